; A transistor for the Sentaurus Structure Editor (own sample): what cover reads of such decks.
(sde:clear)
(define Lg 0.1)          ; gate length, um
(define Tox 0.0015)
(define Hgate 0.08)
(define Wsd 0.15)
(define Hsub 0.3)
(define (half x) (/ x 2))
(define Xg (half Lg))
(define Xmax (+ Xg Wsd))

(sdegeo:set-default-boolean "ABA")
(sdegeo:create-rectangle (position (- Xmax) 0 0) (position Xmax Hsub 0) "Silicon" "R.Bulk")
(sdegeo:create-rectangle (position (- Xg) (- Tox) 0) (position Xg 0 0) "SiO2" "R.GateOx")
(sdegeo:create-polygon
  (list (position (- Xg) (- Tox) 0) (position Xg (- Tox) 0)
        (position (* 0.9 Xg) (- (+ Tox Hgate)) 0) (position (* -0.9 Xg) (- (+ Tox Hgate)) 0))
  "PolySi" "R.Gate")
; source and drain are drawn under what is there already
(sdegeo:set-default-boolean "BAB")
(define Spacer 0.02)
(sdegeo:create-rectangle (position (- (+ Xg Spacer)) (- Hgate) 0) (position (+ Xg Spacer) 0 0) "Si3N4" "R.Spacer")

(sdegeo:define-contact-set "source" 4 (color:rgb 1 0 0) "##")
(sdegeo:define-contact-set "drain" 4 (color:rgb 0 1 0) "##")
(sdegeo:define-contact-set "gate" 4 (color:rgb 0 0 1) "##")
(sdegeo:define-contact-set "bulk" 4 (color:rgb 0 0 1) "##")
(sdegeo:set-current-contact-set "source")
(sdegeo:set-contact-edges (list (car (find-edge-id (position (- (+ Xg Spacer 0.01)) 0 0)))) "source")
(sdegeo:define-2d-contact (find-edge-id (position (+ Xg Spacer 0.01) 0 0)) "drain")
(sdegeo:define-2d-contact (find-edge-id (position 0 (- (+ Tox Hgate)) 0)) "gate")
(sdegeo:set-current-contact-set "bulk")
(sdegeo:set-contact-edges (find-edge-id (position 0 Hsub 0)))

(sdedr:define-constant-profile "P.Bulk" "BoronActiveConcentration" 1e17)
(sdedr:define-constant-profile-region "Place.Bulk" "P.Bulk" "R.Bulk")
(sdegeo:fillet-2d (find-vertex-id (position (* 0.9 Xg) (- (+ Tox Hgate)) 0)) 0.005)
(sde:build-mesh "snmesh" "" "nmos")
