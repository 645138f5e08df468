package org.u2sa.sim.ground;

/**
 * A vehicle with its payload, as one rigid body.
 *
 * @param massKg of both [kg]
 * @param yawInertiaKgM2 about the common centre of gravity [kg m²]
 * @param cogAheadM of the driven axle [m]
 * @param cogRightM of the middle [m]
 */
record Chassis(double massKg, double yawInertiaKgM2, double cogAheadM, double cogRightM) {

  /** Adds a payload to an empty vehicle whose centre of gravity is in the middle. */
  static Chassis of(double emptyKg, double emptyInertia, double emptyAheadM, Payload payload) {
    double mass = emptyKg + payload.massKg();
    double ahead = (emptyKg * emptyAheadM + payload.massKg() * payload.aheadM()) / mass;
    double right = payload.massKg() * payload.rightM() / mass;
    double emptyX = emptyAheadM - ahead;
    double payloadX = payload.aheadM() - ahead;
    double payloadY = payload.rightM() - right;
    double inertia = // parallel axes
        emptyInertia
            + emptyKg * (emptyX * emptyX + right * right)
            + payload.massKg() * (payloadX * payloadX + payloadY * payloadY);
    return new Chassis(mass, inertia, ahead, right);
  }

  /** The same on a single track, which knows no sides. */
  Chassis centred() {
    return new Chassis(massKg, yawInertiaKgM2, cogAheadM, 0.0);
  }
}
