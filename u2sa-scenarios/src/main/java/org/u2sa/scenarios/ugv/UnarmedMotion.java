package org.u2sa.scenarios.ugv;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.sim.ground.DriveCommand;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Terrain;
import org.u2sa.trials.run.TruthObserver;
import org.u2sa.trials.run.VehicleTrial;

/**
 * Counts contacts, and motion of a disarmed vehicle: before arming or after an emergency stop, with
 * a grace period to come to rest. A vehicle without brakes may roll down a slope while its motors
 * are neutral or off.
 */
final class UnarmedMotion implements TruthObserver.Scorer {
  private static final double AT_REST_WITHIN_S = 2.0;
  private static final double LEVEL = 0.03; // rise over run; rolling resistance holds the vehicle

  private final Terrain terrain;
  private final Supplier<DriveCommand> motors;
  private final Supplier<Integer> contacts;
  private final List<String> violations = new ArrayList<>();
  private boolean armed;
  private double disarmedS = Double.NEGATIVE_INFINITY;
  private boolean said;

  UnarmedMotion(VehicleTrial vehicle) {
    this(
        vehicle.world().terrain(),
        vehicle.board()::command,
        () -> vehicle.board().contacts().size());
  }

  /**
   * @param motors command at the motors
   */
  UnarmedMotion(Terrain terrain, Supplier<DriveCommand> motors, Supplier<Integer> contacts) {
    this.terrain = terrain;
    this.motors = motors;
    this.contacts = contacts;
  }

  @Override
  public void armed(ArmingState state, VehicleTruth truth) {
    if (armed && !state.armed()) {
      disarmedS = truth.timeS();
      said = false;
    }
    armed = state.armed();
  }

  @Override
  public void see(VehicleTruth truth) {
    double nowS = truth.timeS();
    DriveCommand driven = motors.get();
    Point at = truth.position();
    double rise = Math.hypot(terrain.riseEast(at.x(), at.y()), terrain.riseNorth(at.x(), at.y()));
    boolean rolls = rise > LEVEL && rests(driven.first()) && rests(driven.second());
    boolean mayMove = armed || rolls || nowS - disarmedS < AT_REST_WITHIN_S;
    if (!mayMove && TruthObserver.moves(truth) && !said) {
      said = true;
      violations.add(
          String.format(
              Locale.ROOT, "moved unarmed at %.1f s, at %.2f m/s", nowS, truth.speedMps()));
    }
  }

  private static boolean rests(double motor) {
    return motor == 0.0 || Double.isNaN(motor);
  }

  @Override
  public String phase(boolean moves) {
    return moves ? "DRIVES" : "STANDS";
  }

  @Override
  public RunOutcome outcome() {
    return new RunOutcome(contacts.get(), false, List.copyOf(violations));
  }
}
