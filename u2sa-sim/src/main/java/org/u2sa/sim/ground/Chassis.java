package org.u2sa.sim.ground;

/**
 * Mass properties of a vehicle with its payload.
 *
 * @param massKg total mass [kg]
 * @param yawInertiaKgM2 about the common centre of gravity [kg m²]
 * @param cogAheadM centre of gravity ahead of the driven axle [m]
 * @param cogRightM centre of gravity right of the centre line [m]
 */
record Chassis(double massKg, double yawInertiaKgM2, double cogAheadM, double cogRightM) {

  /** Adds a payload to a vehicle whose own centre of gravity is on the centre line. */
  static Chassis of(double emptyKg, double emptyInertia, double emptyAheadM, Payload payload) {
    double mass = emptyKg + payload.massKg();
    double ahead = (emptyKg * emptyAheadM + payload.massKg() * payload.aheadM()) / mass;
    double right = payload.massKg() * payload.rightM() / mass;
    double emptyX = emptyAheadM - ahead;
    double payloadX = payload.aheadM() - ahead;
    double payloadY = payload.rightM() - right;
    double inertia = // parallel-axis theorem
        emptyInertia
            + emptyKg * (emptyX * emptyX + right * right)
            + payload.massKg() * (payloadX * payloadX + payloadY * payloadY);
    return new Chassis(mass, inertia, ahead, right);
  }

  /** Likewise for a single-track model, which ignores lateral offsets. */
  Chassis centred() {
    return new Chassis(massKg, yawInertiaKgM2, cogAheadM, 0.0);
  }
}
