(define (f x) (begin (f x) (f x)))
(f 1)
