package org.u2sa.flightgear.link;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.aircraft.AircraftMotion;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.aircraft.ControlInputs;

/**
 * The embedded Cessna 172 in this process: each reading brings it to the time of the run, so it
 * moves in lockstep.
 */
public final class EmbeddedAircraft implements AircraftLink {
  private final Cessna172 aircraft;
  private long startMicros = -1;
  private long steppedMicros;
  private long sequence;
  private ControlInputs controls = ControlInputs.neutral();

  /** Links to an aircraft that nobody else steps. */
  public EmbeddedAircraft(Cessna172 aircraft) {
    this.aircraft = aircraft;
  }

  /** The aircraft, to be looked at only. */
  Cessna172 aircraft() {
    return aircraft;
  }

  @Override
  public AircraftReading read(long nowMicros) {
    if (startMicros < 0) {
      startMicros = nowMicros;
    }
    long elapsedMicros = nowMicros - startMicros;
    if (elapsedMicros > steppedMicros) {
      aircraft.step(controls, Clock.seconds(elapsedMicros - steppedMicros));
      steppedMicros = elapsedMicros;
      sequence++;
    }
    return reading(aircraft.state(), Math.max(1, sequence), nowMicros);
  }

  @Override
  public void write(ControlInputs newControls) {
    controls = newControls;
  }

  @Override
  public String trouble() {
    return "";
  }

  @Override
  public void close() {
    // Nothing is open: the aircraft is an object of this process.
  }

  /** The state as a reading. */
  static AircraftReading reading(AircraftMotion state, long sequence, long measuredAtMicros) {
    Point euler =
        new Attitude(state.rollRad(), state.pitchRad(), state.headingRad())
            .eulerRates(
                Point.of(
                    state.rollRateRadPerS(), state.pitchRateRadPerS(), state.yawRateRadPerS()));
    double alongPlaneMps = state.trueAirspeedMps() * Math.cos(state.sideslipRad());
    return new AircraftReading(
        true,
        sequence,
        measuredAtMicros,
        state.longitudeDeg(),
        state.latitudeDeg(),
        state.altitudeM(),
        state.heightAboveGroundM(),
        state.rollRad(),
        state.pitchRad(),
        state.headingRad(),
        euler.x(),
        euler.y(),
        euler.z(),
        state.velocityNorthMps(),
        state.velocityEastMps(),
        -state.velocityDownMps(),
        alongPlaneMps * Math.cos(state.angleOfAttackRad()),
        -state.trueAirspeedMps() * Math.sin(state.sideslipRad()),
        alongPlaneMps * Math.sin(state.angleOfAttackRad()),
        state.calibratedAirspeedMps(),
        state.engineRpm(),
        state.weightOnWheels(),
        false,
        state.crashed());
  }
}
