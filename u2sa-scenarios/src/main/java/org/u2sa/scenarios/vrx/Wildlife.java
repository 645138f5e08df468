package org.u2sa.scenarios.vrx;

import java.util.List;
import org.u2sa.sim.world.ScriptedMover;

/**
 * Animals, each a buoy that swims back and forth.
 *
 * @param engagementM distance within which the boat is engaged with an animal [m]
 * @param bonusS time bonus per completed goal [s]
 */
record Wildlife(List<Animal> animals, double engagementM, double bonusS) {
  /** Treatment of an animal; in VRX, these are crocodile, platypus and turtle. */
  enum Part {
    /** Keep away from it. */
    AVOID("crocodile"),
    /** Circle it clockwise. */
    CLOCKWISE("platypus"),
    /** Circle it anticlockwise. */
    ANTICLOCKWISE("turtle");

    private final String species;

    Part(String species) {
      this.species = species;
    }

    /** Name that VRX announces. */
    String species() {
      return species;
    }
  }

  /**
   * One animal.
   *
   * @param mover its motion
   */
  record Animal(String name, Part part, ScriptedMover mover) {}

  /** No animals, for other tasks. */
  static Wildlife none() {
    return new Wildlife(List.of(), 0.0, 0.0);
  }
}
