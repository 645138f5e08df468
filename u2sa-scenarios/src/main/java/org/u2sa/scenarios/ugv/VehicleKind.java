package org.u2sa.scenarios.ugv;

import org.u2sa.sim.ground.AckermannParameters;
import org.u2sa.sim.ground.AckermannVehicle;
import org.u2sa.sim.ground.DifferentialParameters;
import org.u2sa.sim.ground.DifferentialVehicle;
import org.u2sa.sim.ground.GroundStart;
import org.u2sa.sim.ground.GroundVehicle;
import org.u2sa.sim.ground.Payload;

/** Vehicle of the demo. */
enum VehicleKind {
  /** The thesis's Mini-Molle: two driven wheels and a castor. */
  DIFFERENTIAL("Mini-Molle") {
    @Override
    GroundVehicle make(GroundStart start, double mismatch, double payloadKg) {
      DifferentialParameters empty = DifferentialParameters.miniMolle().withMismatch(mismatch);
      return new DifferentialVehicle(
          empty.withPayload(new Payload(payloadKg, empty.cogAheadM(), 0.0)), start);
    }
  },
  /** A 1:10 truck with steered front wheels. */
  ACKERMANN("1:10 truck") {
    @Override
    GroundVehicle make(GroundStart start, double mismatch, double payloadKg) {
      AckermannParameters empty = AckermannParameters.truck();
      return new AckermannVehicle(
          empty.withPayload(new Payload(payloadKg, empty.cogAheadM(), 0.0)), start);
    }
  };

  private final String words;

  VehicleKind(String words) {
    this.words = words;
  }

  /** Name in reports. */
  String words() {
    return words;
  }

  /**
   * Creates a vehicle.
   *
   * @param mismatch fraction by which the right motor is stronger, because no two motors are
   *     identical
   * @param payloadKg payload at the vehicle's centre of gravity [kg]
   */
  abstract GroundVehicle make(GroundStart start, double mismatch, double payloadKg);
}
