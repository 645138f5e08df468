package org.u2sa.sim.ground;

/**
 * One simulated ground vehicle, on level ground until it gets other {@link #terrain}. It steps at
 * 500 Hz inside, whatever steps it is asked for, and gives the same doubles for the same start and
 * inputs on every machine. Not safe for several threads.
 */
public interface GroundVehicle {
  /** Rate of the physics inside [1/s]. */
  int TICKS_PER_SECOND = 500;

  /**
   * Moves on in time. What does not fill a tick of 1/500 s is kept for the next call, so that many
   * small steps equal one large step.
   *
   * @param command held during the step
   * @param dtS above 0, at most 60 s
   * @throws IllegalArgumentException if dt is outside its range
   */
  void step(DriveCommand command, double dtS);

  /** The vehicle as it is now. */
  GroundState state();

  /**
   * Something pushes the vehicle at its centre of gravity, until told otherwise.
   *
   * @param eastN force towards east [N]
   * @param northN force towards north [N]
   * @param turnNm moment, clockwise positive [N m]
   */
  void push(double eastN, double northN, double turnNm);

  /**
   * Exchanges the battery for one with another charge.
   *
   * @param charge 0…1
   */
  void charge(double charge);

  /** Puts hills under the vehicle. */
  void terrain(Terrain terrain);

  /** Exchanges the ground that the vehicle stands on. */
  void ground(Surface surface);
}
