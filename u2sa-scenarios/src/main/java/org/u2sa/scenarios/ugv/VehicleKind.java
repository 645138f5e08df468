package org.u2sa.scenarios.ugv;

/** Vehicle of the demo. */
enum VehicleKind {
  /** The thesis's Mini-Molle: two driven wheels and a castor. */
  DIFFERENTIAL("differential", "vehicle.xml"),
  /** A 1:10 truck with steered front wheels. */
  ACKERMANN("ackermann", "vehicle-ackermann.xml");

  private final String dynamics;
  private final String file;

  VehicleKind(String dynamics, String file) {
    this.dynamics = dynamics;
    this.file = file;
  }

  /** Element of its dynamics in its file. */
  String dynamics() {
    return dynamics;
  }

  /** Vehicle file in {@code config/ugv}. */
  String file() {
    return file;
  }
}
