// Only carries the precompiled header of the tests; main comes from preshape_test_main.
