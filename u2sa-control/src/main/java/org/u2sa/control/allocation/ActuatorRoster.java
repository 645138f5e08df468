package org.u2sa.control.allocation;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;

/**
 * Tracks which actuators are present, by their announcements. An actuator is lost if its
 * announcement was not renewed for three renewal periods, was withdrawn or offers no effect, or if
 * its service failed or disconnected. Its next announcement ends that. Not thread-safe.
 */
public final class ActuatorRoster {
  private static final double RENEWAL_S = 5.0; // for actuators that announce none
  private static final double MISSED = 3.0;
  private static final double ALL_PERCENT = 100.0;
  private static final int MAX_KNOWN = 500; // beyond this number, absent ones are dropped

  /** State of one actuator. */
  private static final class Known {
    private ActuatorAnnouncement announced;
    private long heardMicros;
    private boolean failed;
    private long revision; // counts announcements that changed something
  }

  private final Map<String, Known> actuators = new TreeMap<>();

  /** Processes an announcement received at the given time. */
  public void see(ActuatorAnnouncement announcement, long nowMicros) {
    if (actuators.size() >= MAX_KNOWN && !actuators.containsKey(announcement.actuatorName())) {
      actuators.values().removeIf(each -> !isPresent(each, nowMicros));
    }
    Known known = actuators.computeIfAbsent(announcement.actuatorName(), name -> new Known());
    known.revision += says(known.announced, announcement) ? 0 : 1;
    known.announced = announcement;
    known.heardMicros = nowMicros;
    known.failed = false;
  }

  /** Forgets all but the actuators with these names. */
  public void keep(Predicate<String> names) {
    actuators.keySet().removeIf(names.negate());
  }

  /** Processes a service's health or disconnection. */
  public void see(HealthReport report) {
    if (report.status() == ServiceStatus.FAILED) {
      for (Known known : actuators.values()) {
        known.failed |= known.announced.serviceName().equals(Optional.of(report.serviceName()));
      }
    }
  }

  /** Effectors available for allocation at the given time, sorted by name. */
  public List<Effector> present(long nowMicros) {
    List<Effector> present = new ArrayList<>();
    for (Known known : actuators.values()) {
      if (isPresent(known, nowMicros)) {
        Effector.of(known.announced).ifPresent(present::add);
      }
    }
    return present;
  }

  /** All actuators that have ever announced an effect, as healthy effectors, sorted by name. */
  public List<Effector> sound() {
    List<Effector> sound = new ArrayList<>();
    for (Known known : actuators.values()) {
      Effector.ofSound(known.announced).ifPresent(sound::add);
    }
    return sound;
  }

  /** Revision that changes when an actuator appears, disappears or changes its announcement. */
  public long revision(long nowMicros) {
    long all = 1;
    for (Known known : actuators.values()) {
      all = 1_000_003 * all + (isPresent(known, nowMicros) ? known.revision : 0);
    }
    return all;
  }

  /** Actuators with an effect that are currently lost, sorted by name. */
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
   * Remaining effectiveness of an actuator, with or without a numeric effect, 0…1; 1 if it never
   * announced itself.
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

  /** Whether an actuator has ever announced itself. */
  public boolean knows(String actuator) {
    return actuators.containsKey(actuator);
  }

  /** Whether a pilot's radio or an emergency stop withholds commands from an actuator. */
  public boolean isWithheld(String actuator) {
    Known known = actuators.get(actuator);
    return known != null && known.announced.withheld();
  }

  /** Whether commands are withheld from any of the actuators. */
  public boolean isWithheld() {
    return actuators.values().stream().anyMatch(known -> known.announced.withheld());
  }

  /** Command classes that an actuator accepts besides percentages. */
  public List<String> commandTypes(String actuator) {
    Known known = actuators.get(actuator);
    return known == null ? List.of() : known.announced.commandTypes();
  }

  /** Whether two announcements differ only in their times. */
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
