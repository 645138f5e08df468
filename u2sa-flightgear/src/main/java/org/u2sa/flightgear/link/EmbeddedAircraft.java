package org.u2sa.flightgear.link;

import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.sim.aircraft.AircraftMotion;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.aircraft.ControlInputs;
import org.u2sa.sim.vehicle.VehicleRun;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * The embedded Cessna 172 in this process. Each reading advances it to the run's time, so it moves
 * in lockstep.
 */
public final class EmbeddedAircraft implements AircraftLink {
  private final Cessna172 aircraft;
  private final VehicleRun run;
  private VehicleTruth seen; // null before the first reading
  private long sequence;

  /**
   * Links to an aircraft that no other object advances.
   *
   * @throws BadInputException if it is not a Cessna 172
   */
  public EmbeddedAircraft(VehicleRun run) {
    this.run = run;
    if (!(run.vehicle() instanceof Cessna172 cessna)) {
      throw new BadInputException(
          "the Simulator needs a vehicle file with <cessna172>; this vehicle has "
              + run.vehicle().actuators());
    }
    aircraft = cessna;
  }

  @Override
  public AircraftReading read(long nowMicros) {
    VehicleTruth truth = run.at(nowMicros);
    sequence += seen == null || truth == seen ? 0 : 1;
    seen = truth;
    return reading(aircraft.state(), Math.max(1, sequence), nowMicros);
  }

  @Override
  public void write(ControlInputs controls) {
    aircraft.hold(controls);
  }

  @Override
  public String trouble() {
    return "";
  }

  @Override
  public void close() {
    // Nothing is open: the aircraft is an object of this process.
  }

  /** Converts the simulated motion to a reading. */
  static AircraftReading reading(AircraftMotion state, long sequence, long measuredAtMicros) {
    Point euler =
        new Attitude(state.rollRad(), state.pitchRad(), state.headingRad())
            .eulerRates(
                Point.of(
                    state.rollRateRadPerS(), state.pitchRateRadPerS(), state.yawRateRadPerS()));
    double alongPlaneMps = state.trueAirspeedMps() * Math.cos(state.sideslipRad());
    AircraftState aircraft = new AircraftState();
    aircraft
        .referenceFrame(ReferenceFrame.GLOBAL)
        .x(state.longitudeDeg())
        .y(state.latitudeDeg())
        .z(state.altitudeM())
        .xDot(state.velocityEastMps())
        .yDot(state.velocityNorthMps())
        .zDot(-state.velocityDownMps())
        .phi(state.rollRad())
        .theta(state.pitchRad())
        .psi(state.headingRad())
        .phiDot(euler.x())
        .thetaDot(euler.y())
        .psiDot(euler.z())
        .fluidxDot(alongPlaneMps * Math.cos(state.angleOfAttackRad()))
        .fluidyDot(-state.trueAirspeedMps() * Math.sin(state.sideslipRad()))
        .fluidzDot(alongPlaneMps * Math.sin(state.angleOfAttackRad()));
    aircraft
        .heightAboveGround(state.heightAboveGroundM())
        .calibratedAirspeed(state.calibratedAirspeedMps())
        .engineRpm(state.engineRpm())
        .weightOnWheels(state.weightOnWheels())
        .crashed(state.crashed());
    return new AircraftReading(true, sequence, measuredAtMicros, aircraft);
  }
}
