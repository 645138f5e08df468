package org.u2sa.sim.device;

import java.util.OptionalDouble;
import java.util.Random;
import org.u2sa.device.port.Thruster;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.sensor.NoiseStreams;

/**
 * A thruster with lag and dead band that can be degraded or broken. The vehicle model reads {@link
 * #thrustN}.
 */
public final class SimulatedThruster extends SimulatedDevice<Thruster.Turning> implements Thruster {
  private static final double MICROS_PER_S = 1e6;
  private static final double FULL_PERCENT = 100.0;

  private final Propeller propeller;
  private final Random noise;
  private final long timeoutMicros;
  private double wantedPercent; // applied at the next read
  private double percent; // actual command of the motor; guarded by this, as are all fields below
  private long untilMicros = Long.MIN_VALUE;
  private long atMicros = Long.MIN_VALUE;
  private double rpm;
  private double strength = 1.0;

  /**
   * Thruster parameters.
   *
   * @param rateHz readings per second
   * @param fullRpm speed at 100 % [1/min]
   * @param deadbandPercent dead band: smaller commands produce no rotation [%]
   * @param lagS time constant of the speed [s]
   * @param fullThrustN forward thrust at 100 % [N]
   * @param reverseThrustN magnitude of the reverse thrust at −100 % [N]
   * @param fullCurrentA current at 100 % [A]
   * @param batteryV battery voltage [V]
   * @param timeoutS command time-out, after which it stops [s]
   * @param rpmSigma standard deviation of the measured speed [1/min]
   */
  public record Propeller(
      double rateHz,
      double fullRpm,
      double deadbandPercent,
      double lagS,
      double fullThrustN,
      double reverseThrustN,
      double fullCurrentA,
      double batteryV,
      double timeoutS,
      double rpmSigma) {
    /**
     * @throws IllegalArgumentException if a value is outside its range
     */
    public Propeller {
      Arguments.requirePositive("full speed", fullRpm);
      Arguments.requireInside("deadband", deadbandPercent, 0.0, 99.0);
      Arguments.requirePositive("lag", lagS);
      Arguments.requirePositive("full thrust", fullThrustN);
      Arguments.requirePositive("reverse thrust", reverseThrustN);
      Arguments.requireInside("full current", fullCurrentA, 0.0, 10_000.0);
      Arguments.requireInside("battery voltage", batteryV, 0.0, 1_000.0);
      Arguments.requirePositive("time-out", timeoutS);
      Arguments.requireInside("noise of the speed", rpmSigma, 0.0, fullRpm);
    }

    /**
     * Blue Robotics T200 at 16 V, data sheet: 5.25 and 4.1 kgf, 24 A, dead band ±25 of 400 µs. Lag
     * and top speed are typical values, not from the data sheet.
     */
    public static Propeller t200() {
      return new Propeller(20.0, 3_700.0, 6.25, 0.1, 51.5, 40.2, 24.0, 16.0, 0.5, 5.0);
    }
  }

  /** Uses the random stream {@code name}. */
  public SimulatedThruster(Propeller propeller, NoiseStreams streams, String name) {
    super(propeller.rateHz(), 0.0);
    this.propeller = propeller;
    noise = streams.of(name);
    timeoutMicros = Math.round(propeller.timeoutS() * MICROS_PER_S);
  }

  /** Thrust at the given time of the run's clock, forward positive [N]. Thread-safe. */
  public synchronized double thrustN(long nowMicros) {
    advance(nowMicros);
    return pushN();
  }

  /** With T = k·n·|n| (Fossen, Handbook of Marine Craft Hydrodynamics, chapter on propulsion). */
  private double pushN() {
    double share = rpm / propeller.fullRpm();
    double fullN = rpm > 0.0 ? propeller.fullThrustN() : propeller.reverseThrustN();
    return strength * fullN * share * Math.abs(share);
  }

  /**
   * Degrades the thruster, as weeds or a broken blade do. Thread-safe.
   *
   * @param share remaining fraction of thrust, 0…1; at 0 it stops turning
   */
  public synchronized void weaken(double share) {
    strength = Arguments.requireInside("share of the thrust", share, 0.0, 1.0);
  }

  private void advance(long nowMicros) {
    if (atMicros == Long.MIN_VALUE) {
      atMicros = nowMicros;
    }
    relax(percent, Math.min(nowMicros, untilMicros));
    relax(0.0, nowMicros);
  }

  /** A first-order lag, exact for a constant command. */
  private void relax(double commandPercent, long toMicros) {
    if (toMicros <= atMicros) {
      return;
    }
    boolean turns = Math.abs(commandPercent) > propeller.deadbandPercent() && strength > 0.0;
    double target = turns ? propeller.fullRpm() * commandPercent / FULL_PERCENT : 0.0;
    double passedS = (toMicros - atMicros) / MICROS_PER_S;
    rpm = target + (rpm - target) * StrictMath.exp(-passedS / propeller.lagS());
    atMicros = toMicros;
  }

  @Override
  synchronized void tell(long nowMicros) {
    advance(nowMicros);
    percent = wantedPercent;
    untilMicros = nowMicros + timeoutMicros;
  }

  @Override
  protected synchronized Turning measure(double timeS, long measuredAtMicros) {
    double share = Math.abs(rpm) / propeller.fullRpm();
    double measured = rpm + propeller.rpmSigma() * noise.nextGaussian();
    return new Turning(
        measuredAtMicros,
        OptionalDouble.of(measured),
        OptionalDouble.empty(),
        OptionalDouble.of(propeller.fullCurrentA() * share * share * share), // power ~ n³
        OptionalDouble.of(propeller.batteryV()));
  }

  @Override
  public void thrust(double newPercent) {
    wantedPercent = Math.max(-FULL_PERCENT, Math.min(FULL_PERCENT, newPercent));
  }

  @Override
  public synchronized void stop(long nowMicros) {
    wantedPercent = 0.0;
    if (isConnected()) {
      tell(nowMicros);
    }
  }

  @Override
  public void leave() {
    // it keeps turning until the time-out
  }

  @Override
  public synchronized void close() {
    wantedPercent = 0.0;
    if (isConnected()) {
      percent = 0.0;
    }
  }
}
