package org.u2sa.gcs.mavlink.command;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.IntFunction;
import org.u2sa.gcs.mavlink.plan.PlanBook;
import org.u2sa.gcs.mavlink.telemetry.Placement;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.gcs.mavlink.vehicle.VehicleMode;
import org.u2sa.gcs.mavlink.vehicle.VehicleOrders;
import org.u2sa.gcs.mavlink.vehicle.VehicleOrders.Answer;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;

/** Commands that change what the vehicle does. */
public final class VehicleCommands {
  private static final int RETURN = 20; // MAV_CMD numbers
  private static final int LAND = 21;
  private static final int TAKE_OFF = 22;
  private static final int SET_MODE = 176;
  private static final int CHANGE_SPEED = 178;
  private static final int TERMINATE = 185;
  private static final int REPOSITION = 192;
  private static final int PAUSE_CONTINUE = 193;
  private static final int SET_CURRENT = 224;
  private static final int START = 300;
  private static final int ARM = 400;
  private static final int PRE_ARM_CHECKS = 401;
  private static final Set<Integer> BY_NAVIGATION =
      Set.of(RETURN, LAND, TAKE_OFF, REPOSITION, PAUSE_CONTINUE, SET_CURRENT, START);
  private static final float FORCED = 21_196.0f; // second parameter of ARM
  private static final double HIGH_M = 3.0; // height above home that counts as in the air
  private static final double TAKE_OFF_M = 50.0;
  private static final double AHEAD_M = 2000.0; // a plane cannot climb vertically

  private final VehicleStatus vehicle;
  private final VehicleOrders orders;
  private final Identity identity;
  private final Placement placement;
  private final PlanBook book;
  private final ModeOrders modes;
  private final IntFunction<String> drivers;

  /**
   * @param drivers name of the person driving by hand at a station, by its MAVLink system ID
   */
  public VehicleCommands(
      VehicleStatus vehicle,
      VehicleOrders orders,
      Identity identity,
      Placement placement,
      PlanBook book,
      IntFunction<String> drivers) {
    this.vehicle = vehicle;
    this.orders = orders;
    this.identity = identity;
    this.placement = placement;
    this.book = book;
    this.drivers = drivers;
    modes = new ModeOrders(vehicle, orders, book);
  }

  /**
   * Changes to a mode by its number.
   *
   * @param station MAVLink system ID of the station
   */
  void mode(long custom, int station, Answer answer) {
    Optional<VehicleMode> mode = identity.mode(custom, vehicle.kind());
    Optional<Integer> planner = identity.planner(custom, vehicle.planners());
    if (planner.isPresent() || mode.filter(VehicleMode.MISSION::equals).isPresent()) {
      byNavigation(() -> modes.mission(planner, answer), answer);
    } else if (mode.isEmpty()) {
      answer.done(false, "the vehicle has no mode " + custom);
    } else if (mode.get() == VehicleMode.MANUAL) {
      orders.manual(true, drivers.apply(station), answer);
    } else {
      byNavigation(() -> modes.change(mode.get(), answer), answer);
    }
  }

  /** Ends manual driving, if active, before an order that hands the vehicle to navigation. */
  private void byNavigation(Runnable then, Answer answer) {
    Optional<String> driver = vehicle.driver();
    if (driver.isEmpty()) {
      then.run();
    } else {
      orders.manual(
          false,
          driver.get(),
          (ended, why) -> {
            if (ended) {
              then.run();
            } else {
              answer.done(false, why);
            }
          });
    }
  }

  /**
   * Executes a command; false if it is not one of these.
   *
   * @param station MAVLink system ID of the station
   */
  boolean obey(Command command, int station, Answer answer) {
    if (BY_NAVIGATION.contains(command.id())) {
      byNavigation(() -> carryOut(command, station, answer), answer);
      return true;
    }
    return carryOut(command, station, answer);
  }

  private boolean carryOut(Command command, int station, Answer answer) {
    switch (command.id()) {
      case ARM -> arm(command, answer);
      case PRE_ARM_CHECKS ->
          answer.done(
              vehicle.reasonsAgainstArming().isEmpty(),
              String.join("; ", vehicle.reasonsAgainstArming()));
      case RETURN -> modes.change(VehicleMode.RETURN, answer);
      case LAND -> modes.change(VehicleMode.LAND, answer);
      case TAKE_OFF -> takeOff(command, answer);
      case SET_MODE -> mode(identity.custom(command.param2(), command.param3()), station, answer);
      case CHANGE_SPEED -> speed(command.param2(), answer);
      case TERMINATE -> terminate(command, answer);
      case REPOSITION -> reposition(command, answer);
      case PAUSE_CONTINUE ->
          modes.change(command.param1() >= 0.5f ? VehicleMode.MISSION : VehicleMode.HOLD, answer);
      case SET_CURRENT -> modes.goTo(book.goal((int) command.param1()), answer);
      case START -> start(command, answer);
      default -> {
        return false;
      }
    }
    return true;
  }

  private void arm(Command command, Answer answer) {
    boolean arm = command.param1() == 1.0f;
    if (!arm && command.param1() != 0.0f) {
      answer.done(false, "arm " + command.param1() + "; expected 1, or 0 to disarm");
    } else if (!arm && command.param2() != FORCED && flies()) {
      answer.done(false, "not disarmed in the air: land, or force it");
    } else {
      orders.arm(arm, answer);
    }
  }

  /**
   * Whether the vehicle is airborne, judged by its wheels or else by its height above home; true if
   * the height is not known.
   */
  private boolean flies() {
    if (vehicle.kind().isOnSurface() || !vehicle.isArmed()) {
      return false;
    }
    Optional<StateInformation> state = vehicle.state();
    if (state.isPresent() && state.get() instanceof AircraftState aircraft) {
      return !aircraft.weightOnWheels();
    }
    OptionalDouble downM =
        placement.local().map(StateInformation::z).orElse(OptionalDouble.empty());
    return !(-downM.orElse(Double.NaN) <= HIGH_M);
  }

  private void start(Command command, Answer answer) {
    if (command.param1() > 0.0f) {
      modes.goTo(book.goal((int) command.param1()), answer);
    } else {
      modes.mission(answer);
    }
  }

  private void speed(float metresPerSecond, Answer answer) {
    if (metresPerSecond > 0.0f && Float.isFinite(metresPerSecond)) {
      modes.speed(metresPerSecond, answer);
    } else {
      answer.done(false, "speed " + metresPerSecond + " m/s; expected more than 0");
    }
  }

  private void terminate(Command command, Answer answer) {
    if (command.param1() < 0.5f) {
      answer.done(false, "only ./u2sa estop --clear can lift an emergency stop");
    } else {
      orders.stop("terminated by a ground station", answer);
    }
  }

  private void takeOff(Command command, Answer answer) {
    Optional<StateInformation> here = placement.global();
    if (vehicle.kind().isOnSurface() || here.isEmpty()) {
      answer.done(
          false, here.isEmpty() ? "no position on the earth" : "this vehicle does not take off");
      return;
    }
    Optional<String> refusal = command.frameRefusal(placement.home());
    if (refusal.isPresent()) {
      answer.done(false, refusal.get());
      return;
    }
    double altitudeM =
        command.altitudeM(placement.home()).orElse(here.get().z().orElse(0.0) + TAKE_OFF_M);
    if (altitudeM <= here.get().z().orElse(Double.NEGATIVE_INFINITY)) {
      answer.done(
          false,
          String.format(Locale.ROOT, "%.0f m above sea level is not above the vehicle", altitudeM));
      return;
    }
    Geodetic place = place(here.get());
    if (vehicle.kind() == VehicleKind.PLANE) {
      place = place.destination(here.get().psi().orElse(0.0), AHEAD_M);
    }
    modes.goTo(place, OptionalDouble.of(altitudeM), OptionalDouble.empty(), answer);
  }

  private static Geodetic place(StateInformation global) {
    return new Geodetic(global.x().getAsDouble(), global.y().getAsDouble(), global.z().orElse(0.0));
  }

  /** Without a place this is the pause button of QGroundControl. */
  private void reposition(Command command, Answer answer) {
    if (!command.hasPlace()) {
      modes.change(VehicleMode.HOLD, answer);
      return;
    }
    Optional<String> refusal = command.frameRefusal(placement.home());
    if (refusal.isPresent()) {
      answer.done(false, refusal.get());
      return;
    }
    Optional<StateInformation> here = placement.global();
    OptionalDouble altitudeM = OptionalDouble.empty();
    if (!vehicle.kind().isOnSurface()) {
      Optional<Double> given = command.altitudeM(placement.home());
      altitudeM =
          given.isPresent()
              ? OptionalDouble.of(given.get())
              : here.map(StateInformation::z).orElse(OptionalDouble.empty());
    }
    boolean hasSpeed = command.param1() > 0.0f && Float.isFinite(command.param1());
    modes.goTo(
        new Geodetic(command.longitude(), command.latitude(), altitudeM.orElse(0.0)),
        altitudeM,
        hasSpeed ? OptionalDouble.of(command.param1()) : OptionalDouble.empty(),
        answer);
  }
}
