package org.u2sa.core.control.ground;

import java.util.OptionalDouble;
import org.u2sa.service.HandOver;

/**
 * Takes out by how much a vehicle is steadily slower than it is told to: slopes, soft ground, its
 * load, a battery that runs down. An integral of the error, bounded by what the motors can; it is
 * none while the vehicle stands, so that what is to stand never creeps, and begins anew with each
 * drive and each turn.
 */
final class TurnTrim {
  private final String name;
  private double trim;
  private boolean drove;

  /**
   * @param name under which it is handed over
   */
  TurnTrim(String name) {
    this.name = name;
  }

  void handOver(HandOver state) {
    state.number(name, trim).flag(name + " DROVE", drove);
  }

  void takeOver(HandOver state) {
    trim = state.number(name).orElse(0.0);
    drove = state.flag(name + " DROVE");
  }

  /**
   * What to add to what is demanded.
   *
   * @param demanded what the motors are told
   * @param error of the same quantity, demanded less measured; empty if unknown
   * @param atFullPower whether the motors give all that they can: more would only be wound up
   * @param gain share of an error corrected per second [1/s]; 0: no feedback
   * @param most of demanded and trim together, either way
   */
  double step(
      Drive demanded,
      OptionalDouble error,
      boolean atFullPower,
      double gain,
      double most,
      double stepS) {
    boolean drives = demanded.speedMps() > 0.0;
    if (demanded.isStanding() || drives != drove || gain == 0.0) {
      trim = 0.0;
    }
    drove = drives;
    if (!demanded.isStanding() && error.isPresent()) {
      double speed = demanded.speedMps();
      double more = gain * stepS * error.getAsDouble();
      trim += atFullPower ? Math.min(0.0, more) : more;
      trim = Math.max(-most - speed, Math.min(most - speed, trim));
    }
    return trim;
  }
}
