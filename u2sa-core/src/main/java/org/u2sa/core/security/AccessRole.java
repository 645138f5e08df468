package org.u2sa.core.security;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;

/** What a user of the broker is for. It decides what the user may publish; everyone may read. */
public enum AccessRole {
  /** Sensors, estimators, planners: measures, estimates, plans, and answers requests. */
  SERVICE(true, services()),
  /** The control system: a service that commands actuators. */
  CONTROL(true, services(), List.of(Permission.all("actuation"))),
  /** Starts and stops the services of a process: a service that says what came of an order. */
  LAUNCHER(true, services(), List.of(Permission.of("service-orders", "ServiceOrderResult"))),
  /** The health monitor: a service that judges the others and orders restarts. */
  MONITOR(
      true,
      services(),
      List.of(Permission.all("conditions"), Permission.of("service-orders", "ServiceOrder"))),
  /** The safety manager: a service that sets failsafes, arms, and sets the emergency stop. */
  SAFETY(
      true,
      services(),
      List.of(
          Permission.all("failsafe"),
          Permission.all("arming-state"),
          Permission.all("emergency-stop"))),
  /** People who command the vehicle: stop, configure, swap, arm, clear the emergency stop. */
  OPERATOR(
      false,
      asking(),
      answering(),
      List.of(
          Permission.all("stop"),
          Permission.of(
              "configuration",
              "ConfigurationChange",
              "ConfigurationTransaction",
              "ConfigurationUndo"),
          Permission.of("service-orders", "ServiceOrder"),
          Permission.all("emergency-stop"),
          Permission.all("arming"),
          Permission.all("operator"),
          Permission.all("goal-updates"),
          Permission.all("goal-commands"))),
  /** Screens and recorders: asks who is there and how it is configured, changes nothing. */
  OBSERVER(false, asking());

  private final boolean ownChannels;
  private final List<Permission> permissions;

  @SafeVarargs
  AccessRole(boolean ownChannels, List<Permission>... groups) {
    this.ownChannels = ownChannels;
    List<Permission> all = new ArrayList<>();
    for (List<Permission> group : groups) {
      all.addAll(group);
    }
    permissions = Collections.unmodifiableList(all);
  }

  private static List<Permission> asking() {
    return List.of(
        Permission.of("discovery", "DiscoveryRequest"),
        Permission.of("functionality", "FunctionalityRequest"),
        Permission.of("configuration", "ConfigurationRequest"));
  }

  private static List<Permission> answering() {
    return List.of(
        Permission.of("discovery", "DiscoveryResponse"),
        Permission.of("functionality", "FunctionalityResponse"),
        Permission.of(
            "configuration",
            "ConfigurationResponse",
            "ConfigurationChangeResult",
            "ConfigurationTransactionResult"),
        Permission.all("health"));
  }

  private static List<Permission> services() {
    List<Permission> all = new ArrayList<>(asking());
    all.addAll(answering());
    for (String channel :
        List.of(
            "sensed-state",
            "state",
            "sensed-objects",
            "scans",
            "objects",
            "goals",
            "goal-reports",
            "goal-updates",
            "navigation",
            "actuators",
            "power")) {
      all.add(Permission.all(channel));
    }
    return all;
  }

  /** Whether the role may publish the message of that topic, in a system in which it may act. */
  public boolean mayPublish(Topic topic) {
    String firstType = topic.typeChain().get(0);
    for (Permission permission : permissions) {
      if (permission.covers(topic.channel(), firstType)) {
        return true;
      }
    }
    return ownChannels && Channels.named(topic.channel()).isEmpty();
  }

  /** All that the role may publish on standard channels. */
  public List<Permission> permissions() {
    return permissions;
  }

  /** Whether the role may also publish on channels that are no standard ones. */
  public boolean mayPublishOnOwnChannels() {
    return ownChannels;
  }

  /** The name as it stands in files and on the command line. */
  public String text() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The role of that name. */
  public static Optional<AccessRole> named(String text) {
    return Arrays.stream(values()).filter(role -> role.text().equals(text)).findFirst();
  }
}
