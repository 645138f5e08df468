package org.u2sa.service;

import static org.u2sa.interfaces.communication.Channels.ACTUATION;
import static org.u2sa.interfaces.communication.Channels.ACTUATORS;
import static org.u2sa.interfaces.communication.Channels.ARMING;
import static org.u2sa.interfaces.communication.Channels.ARMING_STATE;
import static org.u2sa.interfaces.communication.Channels.CONDITIONS;
import static org.u2sa.interfaces.communication.Channels.CONFIGURATION;
import static org.u2sa.interfaces.communication.Channels.DISCOVERY;
import static org.u2sa.interfaces.communication.Channels.EMERGENCY_STOP;
import static org.u2sa.interfaces.communication.Channels.FAILSAFE;
import static org.u2sa.interfaces.communication.Channels.FENCE;
import static org.u2sa.interfaces.communication.Channels.FUNCTIONALITY;
import static org.u2sa.interfaces.communication.Channels.GOALS;
import static org.u2sa.interfaces.communication.Channels.GOAL_COMMANDS;
import static org.u2sa.interfaces.communication.Channels.GOAL_REPORTS;
import static org.u2sa.interfaces.communication.Channels.GOAL_UPDATES;
import static org.u2sa.interfaces.communication.Channels.GRID;
import static org.u2sa.interfaces.communication.Channels.GROUND_PRESSURE;
import static org.u2sa.interfaces.communication.Channels.HEALTH;
import static org.u2sa.interfaces.communication.Channels.IMAGES;
import static org.u2sa.interfaces.communication.Channels.LOCAL_STATE;
import static org.u2sa.interfaces.communication.Channels.NAVIGATION;
import static org.u2sa.interfaces.communication.Channels.OBJECTS;
import static org.u2sa.interfaces.communication.Channels.OPERATOR;
import static org.u2sa.interfaces.communication.Channels.PLANS;
import static org.u2sa.interfaces.communication.Channels.POWER;
import static org.u2sa.interfaces.communication.Channels.SCANS;
import static org.u2sa.interfaces.communication.Channels.SENSED_OBJECTS;
import static org.u2sa.interfaces.communication.Channels.SENSED_STATE;
import static org.u2sa.interfaces.communication.Channels.SERVICE_ORDERS;
import static org.u2sa.interfaces.communication.Channels.STATE;
import static org.u2sa.interfaces.communication.Channels.STOP;

import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.schema.U2SAData;

/**
 * Role of a service (thesis figure 3): its standard channels when it registers by class only
 * (thesis 3.2.1.3), and its type in discovery.
 */
public enum ServiceRole {
  /** Measures the vehicle itself (3.2.2.4). */
  PROPRIOCEPTIVE_SENSOR(List.of(SENSED_STATE, POWER), List.of()),
  /** Measures the environment (3.2.2.3). */
  EXTEROCEPTIVE_SENSOR(List.of(SENSED_OBJECTS, SCANS, IMAGES), List.of(STATE)),
  /** Publishes the best estimate of the vehicle's state (3.2.3.1). */
  STATE_ESTIMATOR(List.of(STATE, LOCAL_STATE), List.of(SENSED_STATE)),
  /** Manages the goals (3.2.3.2). */
  MISSION_MANAGER(List.of(GOALS), List.of(GOAL_REPORTS, GOAL_COMMANDS, STATE)),
  /** Maintains the map of objects (3.2.3.3). */
  WORLD_MODELER(List.of(OBJECTS, GRID), List.of(SENSED_OBJECTS, SCANS, STATE, GOALS)),
  /** Decides where to go next (3.2.3.4). */
  PATH_PLANNER(
      List.of(NAVIGATION, GOAL_REPORTS, PLANS), List.of(STATE, OBJECTS, GRID, GOALS, ACTUATORS)),
  /** Turns navigation points into commands (3.2.3.5). */
  CONTROL_SYSTEM(List.of(ACTUATION), List.of(NAVIGATION, STATE, ACTUATORS, GOALS)),
  /** Drives actuators (3.2.2.5). */
  ACTUATOR(List.of(ACTUATORS, SENSED_STATE), List.of(ACTUATION)),
  /** Monitors the other services and orders restarts of failed ones (3.5.3). */
  HEALTH_MONITOR(List.of(CONDITIONS, SERVICE_ORDERS), List.of(HEALTH, SERVICE_ORDERS)),
  /** Decides on failsafe reactions and on arming. */
  SAFETY_MANAGER(
      List.of(FAILSAFE, ARMING_STATE, EMERGENCY_STOP, FENCE),
      List.of(STATE, CONDITIONS, OPERATOR, POWER, ARMING, ACTUATORS, GOALS, EMERGENCY_STOP)),
  /** Starts, restarts and swaps the services of one process or host. */
  LAUNCHER(List.of(SERVICE_ORDERS, HEALTH), List.of(SERVICE_ORDERS)),
  /** Observes, records, or gives orders: displays, ground stations, monitors. */
  OBSERVER(
      List.of(
          GOAL_COMMANDS,
          GOAL_UPDATES,
          STOP,
          CONFIGURATION,
          DISCOVERY,
          FUNCTIONALITY,
          SERVICE_ORDERS,
          EMERGENCY_STOP,
          OPERATOR,
          ARMING,
          GROUND_PRESSURE),
      List.of(
          STATE,
          OBJECTS,
          GRID,
          GOALS,
          NAVIGATION,
          PLANS,
          ACTUATION,
          ACTUATORS,
          HEALTH,
          GOAL_REPORTS,
          SENSED_STATE,
          SENSED_OBJECTS,
          SCANS,
          IMAGES,
          DISCOVERY,
          FUNCTIONALITY,
          CONFIGURATION,
          CONDITIONS,
          SERVICE_ORDERS,
          EMERGENCY_STOP,
          FAILSAFE,
          ARMING_STATE,
          POWER,
          LOCAL_STATE,
          FENCE));

  private final List<Channel<?>> published;
  private final List<Channel<?>> subscribed;

  ServiceRole(List<Channel<?>> published, List<Channel<?>> subscribed) {
    this.published = published;
    this.subscribed = subscribed;
  }

  Channel<?> mainOutput() {
    return published.get(0);
  }

  Optional<Channel<?>> channelToPublish(Class<? extends U2SAData> dataType) {
    return first(published, dataType);
  }

  Optional<Channel<?>> channelToSubscribe(Class<? extends U2SAData> dataType) {
    return first(subscribed, dataType);
  }

  private static Optional<Channel<?>> first(
      List<Channel<?>> channels, Class<? extends U2SAData> dataType) {
    return channels.stream()
        .filter(channel -> channel.type().messageClass().isAssignableFrom(dataType))
        .findFirst();
  }
}
