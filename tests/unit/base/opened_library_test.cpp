#include "base/opened_library.hpp"

#include <gtest/gtest.h>

namespace cover {
namespace {

TEST(OpenedLibrary, GivesFunctionsByTheirNames) {
  OpenedLibrary library("libm.so.6", "/nowhere/libm.so.6");
  double (*cosine)(double) = nullptr;
  library.find("cos", cosine);
  EXPECT_EQ(library.failure(), "");
  ASSERT_NE(cosine, nullptr);
  EXPECT_EQ(cosine(0), 1);
}

TEST(OpenedLibrary, TellsTheFirstNameThatIsMissing) {
  OpenedLibrary library("libm.so.6", "/nowhere/libm.so.6");
  void (*one)() = nullptr, (*two)() = nullptr;
  library.find("no_such_function", one);
  library.find("nor_this", two);
  EXPECT_EQ(one, nullptr);
  EXPECT_EQ(two, nullptr);
  EXPECT_EQ(library.failure(), "libm.so.6 has no no_such_function");
}

TEST(OpenedLibrary, TellsWhyNothingIsOpen) {
  OpenedLibrary library("libnowhere.so.0", "/nowhere/libnowhere.so.0");
  void (*function)() = nullptr;
  library.find("anything", function);
  EXPECT_EQ(function, nullptr);
  EXPECT_NE(library.failure().find("libnowhere.so.0"), std::string::npos) << library.failure();
  EXPECT_EQ(library.failure().find("anything"), std::string::npos) << library.failure();
}

}  // namespace
}  // namespace cover
