package org.u2sa.core.control.allocation;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;

/**
 * Which actuators are there, by their announcements. One is lost when it was not announced anew for
 * three times its renewal, when it is withdrawn or nothing of its effect is available, and when its
 * service's connection broke or its service failed. It is back with its next announcement. For one
 * thread.
 */
public final class ActuatorRoster {
  private static final double RENEWAL_S = 5.0; // of those that announce none
  private static final double MISSED = 3.0;
  private static final double ALL_PERCENT = 100.0;

  /** What is known of one actuator. */
  private static final class Known {
    private ActuatorAnnouncement announced;
    private long heardMicros;
    private boolean failed;
    private long revision; // counts announcements that said something else than the one before
  }

  private final Map<String, Known> actuators = new TreeMap<>();

  /** Takes note of an announcement that came at a time. */
  public void see(ActuatorAnnouncement announcement, long nowMicros) {
    Known known = actuators.computeIfAbsent(announcement.actuatorName(), name -> new Known());
    known.revision += says(known.announced, announcement) ? 0 : 1;
    known.announced = announcement;
    known.heardMicros = nowMicros;
    known.failed = false;
  }

  /** Takes note of a service's health, or of its broken connection. */
  public void see(HealthReport report) {
    if (report.status() == ServiceStatus.FAILED) {
      for (Known known : actuators.values()) {
        known.failed |= known.announced.serviceName().equals(Optional.of(report.serviceName()));
      }
    }
  }

  /** The effectors that can be allocated to at a time, by name. */
  public List<Effector> present(long nowMicros) {
    List<Effector> present = new ArrayList<>();
    for (Known known : actuators.values()) {
      if (isPresent(known, nowMicros)) {
        Effector.of(known.announced).ifPresent(present::add);
      }
    }
    return present;
  }

  /** All that ever announced an effect, as if they were sound, by name. */
  public List<Effector> sound() {
    List<Effector> sound = new ArrayList<>();
    for (Known known : actuators.values()) {
      Effector.ofSound(known.announced).ifPresent(sound::add);
    }
    return sound;
  }

  /** A number that changes when an actuator comes, goes or announces something else. */
  public long revision(long nowMicros) {
    long all = 1;
    for (Known known : actuators.values()) {
      all = 1_000_003 * all + (isPresent(known, nowMicros) ? known.revision : 0);
    }
    return all;
  }

  /** The actuators with an effect that are not present now, by name. */
  public List<String> lost(long nowMicros) {
    List<String> lost = new ArrayList<>();
    actuators.forEach(
        (name, known) -> {
          if (!isPresent(known, nowMicros) && Effector.ofSound(known.announced).isPresent()) {
            lost.add(name);
          }
        });
    return lost;
  }

  /**
   * Share that is left of an actuator, with or without an effect in numbers, 0…1; 1 of one that
   * never announced itself.
   */
  public double left(String actuator, long nowMicros) {
    Known known = actuators.get(actuator);
    if (known == null) {
      return 1.0;
    }
    return isPresent(known, nowMicros)
        ? known.announced.available().orElse(ALL_PERCENT) / ALL_PERCENT
        : 0.0;
  }

  /** The command classes that an actuator takes beside percentages. */
  public List<String> commandTypes(String actuator) {
    Known known = actuators.get(actuator);
    return known == null ? List.of() : known.announced.commandTypes();
  }

  /** Whether two announcements differ in nothing but their times. */
  private static boolean says(ActuatorAnnouncement before, ActuatorAnnouncement now) {
    if (before == null) {
      return false;
    }
    ActuatorAnnouncement same = (ActuatorAnnouncement) now.copy();
    before.timestamp().ifPresent(same::timestamp);
    return same.equals(before);
  }

  private static boolean isPresent(Known known, long nowMicros) {
    double renewalS = known.announced.renewal().orElse(RENEWAL_S);
    return !known.failed
        && known.announced.available().orElse(ALL_PERCENT) > 0.0
        && nowMicros - known.heardMicros <= Clock.micros(MISSED * renewalS);
  }
}
