# Seconds of the longest tests, for ctest, which reads this.
set_tests_properties(SaddleGuesses.FollowTheParameters PROPERTIES COST 156)
set_tests_properties(public_headers PROPERTIES COST 79)
set_tests_properties(Determinism/Scenes.Overlay/geometric PROPERTIES COST 59)
set_tests_properties(Determinism/Scenes.Interior/geometric Escape.BarsCoverWhatJumpsMiss
                     SaddleGuesses.ReachStrainsOfEitherSign PROPERTIES COST 22)
