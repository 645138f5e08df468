package org.u2sa.control.cascade;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.port.Thruster;
import org.u2sa.sim.vehicle.VehicleRun;

/** One propeller of a simulated vessel behind the port of real ones; weeds may catch it. */
final class VesselPropeller implements Thruster {
  private static final double FULL_PERCENT = 100.0;
  private static final double FULL_RPM = 3_700.0;

  private final VehicleRun run;
  private final String name;
  private double percent;
  private boolean isCaught;
  private boolean isPlugged = true;

  VesselPropeller(VehicleRun run, String name) {
    this.run = run;
    this.name = name;
  }

  /** Weeds catch it, or let it go. */
  void caught(boolean now) {
    isCaught = now;
  }

  /** Its wire breaks, or is mended. */
  void plugged(boolean now) {
    isPlugged = now;
  }

  /** What it was told last [%]. */
  double percent() {
    return percent;
  }

  @Override
  public Optional<Turning> read(long nowMicros) {
    double turns = isCaught || !isPlugged ? 0.0 : percent / FULL_PERCENT;
    run.command(nowMicros, name, turns);
    return isPlugged
        ? Optional.of(
            new Turning(
                nowMicros,
                OptionalDouble.of(FULL_RPM * turns),
                OptionalDouble.empty(),
                OptionalDouble.empty(),
                OptionalDouble.empty()))
        : Optional.empty();
  }

  @Override
  public boolean isConnected() {
    return isPlugged;
  }

  @Override
  public String trouble() {
    return isPlugged ? "" : "its wire is broken";
  }

  @Override
  public void thrust(double newPercent) {
    percent = newPercent;
  }

  @Override
  public void stop(long nowMicros) {
    percent = 0.0;
    run.command(nowMicros, name, 0.0);
  }

  @Override
  public void leave() {
    // the successor goes on with it
  }

  @Override
  public void close() {
    percent = 0.0;
  }
}
