package org.u2sa.gcs.mavlink.vehicle;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.LongSupplier;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ConfigurationRequest;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.mission.MissionRequest;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.messages.schema.U2SAData;

/**
 * The vehicle's latest messages. {@link #take} may be called on any thread; messages are frozen, so
 * readers need no lock.
 */
public final class VehicleStatus {
  /** Goal that a go-to order without a speed adds to the mission. */
  public static final String GO_TO = "go-to";

  /** Goal of orders with a speed; separate, because an update cannot remove a speed. */
  public static final String GO_TO_AT_SPEED = "go-to at speed";

  /** Goal that names the home position. */
  public static final String HOME = "home";

  /** Prefix of the names of goals that a landing adds to the mission. */
  public static final String LAND_PREFIX = "LAND ";

  /** Prefix of the UIDs of goals that lead to a place to return to. */
  public static final String RETURN_PREFIX = "RETURN ";

  /** Channels to subscribe to. */
  public static final List<Channel<?>> CHANNELS =
      List.of(
          Channels.STATE,
          Channels.GOALS,
          Channels.MISSION,
          Channels.ARMING,
          Channels.ARMING_STATE,
          Channels.FAILSAFE,
          Channels.FENCE,
          Channels.FENCE_ORDERS,
          Channels.SERVICE_ORDERS,
          Channels.MANUAL_STATE,
          Channels.EMERGENCY_STOP,
          Channels.HEALTH,
          Channels.POWER,
          Channels.CONFIGURATION,
          Channels.DISCOVERY);

  private static final long FRESH_MICROS = 2_000_000;
  private static final int MAX_STOPS = 256;

  private final LongSupplier micros;
  private final Optional<VehicleKind> statedKind;
  private final OrdersUnderWay orders;
  private final PlannerModes planners = new PlannerModes();
  private final ServiceConfigurations configurations = new ServiceConfigurations();
  private final Set<String> stops = ConcurrentHashMap.newKeySet();
  private volatile boolean isReportWanted;
  private volatile VehicleKind heardKind = VehicleKind.GENERIC;
  private volatile StateInformation state; // null until received, like the others
  private volatile long stateMicros;
  private volatile StateInformation first;
  private volatile boolean isFirstArmed; // so the vehicle may have been in the air
  private volatile GoalList goals;
  private volatile MissionReport report;
  private volatile ArmingState arming;
  private volatile FailsafeState failsafe;
  private volatile FenceState fence;
  private volatile ManualState manual;
  private volatile BatteryState battery;

  /**
   * @param micros real time [µs]
   * @param statedKind kind of the vehicle; empty: determined by its control service
   */
  public VehicleStatus(
      LongSupplier micros, Optional<VehicleKind> statedKind, OrdersUnderWay orders) {
    this.micros = micros;
    this.statedKind = statedKind;
    this.orders = orders;
  }

  /** Takes a message of any of {@link #CHANNELS}. */
  public void take(U2SAData message) {
    if (message instanceof StateInformation now) {
      state = now;
      stateMicros = micros.getAsLong();
      boolean isWanted = first == null || isFirstArmed && !isArmed();
      if (isWanted && now.x().isPresent() && now.y().isPresent()) {
        first = now;
        isFirstArmed = isArmed();
      }
    } else if (message instanceof GoalList list) {
      goals = list;
      isReportWanted = true;
    } else if (message instanceof MissionReport found) {
      report = found;
    } else if (message instanceof ArmingState now) {
      isFirstArmed |= arming == null && now.armed(); // the state before it may have been in the air
      arming = now;
    } else if (message instanceof FailsafeState now) {
      failsafe = now;
    } else if (message instanceof FenceState now) {
      fence = now;
    } else if (message instanceof ManualState now) {
      manual = now;
    } else if (message instanceof BatteryState now) {
      battery = now;
    } else if (message instanceof EmergencyStop stop) {
      take(stop);
    } else if (message instanceof DiscoveryResponse response) {
      planners.take(response);
      VehicleKind kind = VehicleKind.ofControl(response.className().orElse(""));
      heardKind = kind == VehicleKind.GENERIC ? heardKind : kind;
    } else {
      configurations.take(message);
    }
    orders.take(message); // last, so that code after an answer sees its effect
  }

  private void take(EmergencyStop stop) {
    if (stop.active()) {
      if (stops.size()
          < MAX_STOPS) { // beyond this number, further ones are ignored until others expire
        stops.add(stop.identity());
      }
    } else if (stop.lifts().isEmpty()) {
      stops.clear();
    } else {
      stops.removeAll(stop.lifts());
    }
  }

  /** Requests data that has changed since the last call. Do not call on the transport's thread. */
  public void refresh() {
    if (isReportWanted) {
      isReportWanted = false;
      orders.tell(Channels.MISSION, new MissionRequest().requestId(UUID.randomUUID().toString()));
    }
    configurations.refresh(orders);
  }

  /** Asks for the mission's state at the next {@link #refresh}. */
  public void wantReport() {
    isReportWanted = true;
  }

  /** Asks all services for their identity and configuration, and for the mission's progress. */
  public void ask() {
    orders.tell(Channels.DISCOVERY, new DiscoveryRequest());
    orders.tell(Channels.CONFIGURATION, new ConfigurationRequest().serviceName(""));
    isReportWanted = true;
  }

  /** Path Planner classes as modes. */
  public PlannerModes planners() {
    return planners;
  }

  /** The vehicle's kind, as far as known. */
  public VehicleKind kind() {
    return statedKind.orElse(heardKind);
  }

  /** State estimate; empty if none arrived within 2 s. */
  public Optional<StateInformation> state() {
    return Optional.ofNullable(state)
        .filter(now -> micros.getAsLong() - stateMicros <= FRESH_MICROS);
  }

  /**
   * First state with a position, used as home if the mission has none; of vehicles that fly, the
   * first one that was heard while they were disarmed, because a bridge may start in flight.
   */
  public Optional<StateInformation> first() {
    return Optional.ofNullable(isFirstArmed && !kind().isOnSurface() ? null : first);
  }

  /** Goals being pursued; empty until heard. */
  public Optional<GoalList> goals() {
    return Optional.ofNullable(goals);
  }

  /** The mission; empty until heard. */
  public Optional<MissionReport> report() {
    return Optional.ofNullable(report);
  }

  /** Home of the mission; empty if it has none. */
  public Optional<Waypoint> home() {
    return report().stream()
        .flatMap(each -> each.goals().stream())
        .filter(goal -> goal.uid().equals(HOME) && goal instanceof Waypoint)
        .map(goal -> (Waypoint) goal)
        .findFirst();
  }

  /** Altitude of the ground at the mission's home [m]; empty if not stated. */
  public OptionalDouble homeAltitudeM() {
    return report().map(MissionReport::homeAltitude).orElse(OptionalDouble.empty());
  }

  /** Newest battery state. */
  public Optional<BatteryState> battery() {
    return Optional.ofNullable(battery);
  }

  /** Whether the vehicle may move; false if unknown. */
  public boolean isArmed() {
    return arming != null && arming.armed();
  }

  /** Reasons against arming; empty if there are none or none is known. */
  public List<String> reasonsAgainstArming() {
    return arming == null
        ? List.of("no Safety Manager found")
        : arming.armed() ? List.of() : arming.reasons();
  }

  /** Failsafe in force. */
  public FailsafeAction failsafe() {
    return failsafe == null ? FailsafeAction.CONTINUE : failsafe.action();
  }

  /** Causes of the failsafe, most severe first. */
  public List<String> failsafeCauses() {
    return failsafe == null ? List.of() : failsafe.causes();
  }

  /** The fence in force; empty until heard. */
  public Optional<FenceState> fence() {
    return Optional.ofNullable(fence);
  }

  /** Person driving the vehicle by hand; empty if none. */
  public Optional<String> driver() {
    return Optional.ofNullable(manual).filter(ManualState::active).map(ManualState::operator);
  }

  /** Whether an emergency stop is in force. */
  public boolean isStopped() {
    return !stops.isEmpty();
  }

  /** Configurations of the vehicle's services. */
  public ServiceConfigurations configurations() {
    return configurations;
  }

  /** UID of the goal being pursued; empty if none is. */
  public Optional<String> current() {
    return goals().flatMap(list -> list.goals().stream().map(GoalInformation::uid).findFirst());
  }

  /** Current mode. */
  public VehicleMode mode() {
    if (driver().isPresent()) {
      return VehicleMode.MANUAL;
    }
    boolean holds = goals == null || goals.paused() || isStopped();
    return switch (failsafe()) {
      case HOLD, STOP -> VehicleMode.HOLD;
      case RETURN -> VehicleMode.RETURN;
      case LAND -> VehicleMode.LAND;
      case CONTINUE ->
          holds ? VehicleMode.HOLD : current().map(this::mode).orElse(VehicleMode.HOLD);
    };
  }

  /** Whether the vehicle is held on its way to home or to another place outside the mission. */
  public boolean isHeldAside() {
    return goals != null
        && goals.paused()
        && current().map(this::mode).filter(mode -> mode != VehicleMode.MISSION).isPresent();
  }

  /** Whether a goal was added by a go-to order. */
  public static boolean isGoTo(String uid) {
    return uid.equals(GO_TO) || uid.equals(GO_TO_AT_SPEED);
  }

  private VehicleMode mode(String uid) {
    if (isGoTo(uid)) {
      return VehicleMode.GO_TO;
    }
    if (uid.equals(HOME) || uid.startsWith(RETURN_PREFIX)) {
      return VehicleMode.RETURN;
    }
    return uid.startsWith(LAND_PREFIX) ? VehicleMode.LAND : VehicleMode.MISSION;
  }
}
