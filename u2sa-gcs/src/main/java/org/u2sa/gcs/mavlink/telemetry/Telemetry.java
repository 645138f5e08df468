package org.u2sa.gcs.mavlink.telemetry;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.gcs.mavlink.vehicle.VehicleSurroundings;

/** The messages available to stations regularly or on request, by message ID. */
public final class Telemetry {
  /** HEARTBEAT. */
  public static final int HEARTBEAT = 0;

  public static final int MISSION_CURRENT = 42;

  /** AUTOPILOT_VERSION. */
  public static final int AUTOPILOT_VERSION = 148;

  public static final int HOME_POSITION = 242;

  /** PROTOCOL_VERSION. */
  public static final int PROTOCOL_VERSION = 300;

  public static final int COMPONENT_METADATA = 397;

  /** CURRENT_EVENT_SEQUENCE. */
  public static final int CURRENT_EVENT_SEQUENCE = 411;

  public static final int AVAILABLE_MODES = 435;

  /**
   * A message.
   *
   * @param usualHz rate without a request [Hz]; 0: only on request
   * @param make makes the message; empty if the vehicle has no such data
   */
  public record Source(double usualHz, Supplier<Optional<Object>> make) {}

  private final Map<Integer, Source> sources = new TreeMap<>();
  private final StatusMessages status;

  /** Creates the messages of a vehicle. */
  public Telemetry(VehicleStatus vehicle, Identity identity, Placement placement, Uptime uptime) {
    status = new StatusMessages(vehicle, identity, placement, uptime);
    MotionMessages motion = new MotionMessages(placement, uptime);
    add(HEARTBEAT, 1.0, status::heartbeat);
    add(1, 1.0, status::systemStatus);
    add(2, 1.0, status::systemTime);
    add(24, 2.0, motion::gps);
    add(30, 10.0, motion::attitude);
    add(31, 0.0, motion::quaternion);
    add(32, 4.0, motion::localPosition);
    add(33, 5.0, motion::globalPosition);
    add(147, 1.0, () -> BatteryMessages.status(vehicle.battery()));
    add(230, 1.0, motion::estimator);
    add(HOME_POSITION, 0.5, status::home);
    add(245, 1.0, status::extendedState);
    add(436, 0.5, status::currentMode);
    add(437, 0.3, status::modesMonitor);
  }

  /** Adds the messages about the vehicle's surroundings and actuators. */
  public void add(VehicleSurroundings surroundings, Placement placement, Uptime uptime) {
    SurroundingsMessages seen = new SurroundingsMessages(surroundings, placement, uptime);
    MotionMessages motion = new MotionMessages(placement, uptime);
    add(36, 2.0, seen::outputs);
    add(74, 4.0, () -> motion.hud(surroundings.throttle()));
    add(231, 1.0, seen::wind);
    add(246, 5.0, seen::traffic);
    add(330, 4.0, seen::obstacles);
  }

  /** Adds the message about the way to the goal. */
  public void add(VehicleStatus vehicle, FollowedRoute route, Placement placement) {
    add(62, 2.0, new NavigationMessages(vehicle, route, placement)::navigation);
  }

  /** Adds a message. */
  public void add(int id, double usualHz, Supplier<Optional<Object>> make) {
    sources.put(id, new Source(usualHz, make));
  }

  /** All messages. */
  public Map<Integer, Source> sources() {
    return sources;
  }

  /** AVAILABLE_MODES at an index from 1; empty beyond the last. */
  public Optional<Object> mode(int index) {
    return status.mode(index);
  }

  /** Number of modes. */
  public int modes() {
    return status.modes();
  }
}
