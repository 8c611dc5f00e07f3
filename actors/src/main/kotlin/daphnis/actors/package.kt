package daphnis.actors
