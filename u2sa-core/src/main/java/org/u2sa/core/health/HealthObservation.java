package org.u2sa.core.health;

import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;

/**
 * Reports of one service and the condition derived from them. Each start of the service is a new
 * instance; reports of superseded instances are ignored.
 */
final class HealthObservation {
  /** Number of missed report intervals after which a service is silent. */
  private static final double SILENT_AFTER = 3.0;

  private static final double USUAL_INTERVAL_S = 0.25;
  private static final int REMEMBERED_INSTANCES = 16;

  /**
   * A condition and the observation it was derived from.
   *
   * @param mayPass whether it is likely to clear without intervention
   */
  record Finding(Condition condition, String reason, boolean mayPass) {}

  private final Set<String> former = new LinkedHashSet<>();
  private String instance = ""; // empty until a report arrives
  private HealthReport last; // of the current instance; null until it reports
  private double heardS; // last report by the current instance or by its launcher
  private double spokeS; // last report by the instance itself
  private double sinceS; // start of waiting, or first report of the current instance
  private boolean lost; // its connection
  private String processEnd = ""; // in words; empty unless reported that its process ended
  private boolean dead; // its thread

  HealthObservation(double nowS) {
    sinceS = nowS;
  }

  /** Handles a report. Returns whether it came from a new instance. */
  boolean hear(HealthReport report, double nowS) {
    String of = report.instance().orElse(instance);
    boolean ofAFormer = former.contains(of);
    if (report instanceof ConnectionLost) {
      if (!ofAFormer || isOfAFailedStart(report)) {
        lose(of, report);
      }
      return false;
    }
    if (ofAFormer) {
      return false;
    }
    boolean isNew = last == null || !of.equals(instance);
    if (isNew) {
      if (!of.equals(instance)) {
        leave(instance);
      }
      instance = of;
      sinceS = nowS;
      lost = false;
      processEnd = "";
      dead = false;
    }
    boolean forItself = report.threadAlive().isEmpty();
    last = report;
    heardS = nowS;
    spokeS = forItself || isNew ? nowS : spokeS;
    lost &= !forItself; // the connection was restored
    dead |= report.threadAlive().equals(Optional.of(false));
    dead &= !(forItself && report.status() == ServiceStatus.RUNNING); // it reports, so it is alive
    return isNew;
  }

  /** Whether a process ended before its service reported, so that no instance is known. */
  static boolean isOfAFailedStart(HealthReport report) {
    return report instanceof ConnectionLost
        && report.instance().isEmpty()
        && report.threadAlive().equals(Optional.of(false));
  }

  /**
   * Handles a broken connection (reported by the broker) or an ended process (reported by a
   * supervisor).
   */
  private void lose(String of, HealthReport word) {
    if (of.equals(instance) && !hasStopped()) {
      lost = true;
      if (word.threadAlive().equals(Optional.of(false))) {
        processEnd = word.lastError().orElse("its process has ended");
      }
    }
  }

  /** Marks an instance as superseded; its later reports are ignored. */
  private void leave(String old) {
    if (!old.isEmpty()) {
      former.add(old);
      if (former.size() > REMEMBERED_INSTANCES) {
        former.remove(former.iterator().next());
      }
    }
  }

  /** Waits for a new instance, if the given one is still current. */
  void expectAnother(String than, double nowS) {
    if (than.equals(instance)) {
      leave(instance);
      last = null;
      sinceS = nowS;
      lost = false;
      processEnd = "";
    }
  }

  void remember(String formerInstance) {
    if (last == null) {
      instance = formerInstance;
    }
  }

  /**
   * Excuses a silence during which the monitor itself could not receive; silence counts from the
   * given time.
   */
  void excuse(double untilS) {
    heardS = untilS;
    spokeS = untilS;
    if (last == null) {
      sinceS = untilS;
    }
  }

  /** Instance heard last; empty if none. */
  String instance() {
    return instance;
  }

  private boolean hasStopped() {
    return last != null && last.status() == ServiceStatus.STOPPED;
  }

  Finding judge(MonitorVariables.Limits limits, double dataTimeoutS, double nowS) {
    if (last == null && !processEnd.isEmpty()) {
      return finding(Condition.LOST, processEnd);
    }
    if (last == null) {
      return nowS - sinceS > limits.startWithin()
          ? finding(Condition.LOST, "not heard for " + seconds(nowS - sinceS))
          : finding(Condition.SILENT, "not heard yet");
    }
    String error = last.lastError().map(text -> ": " + text).orElse("");
    if (hasStopped()) {
      return finding(Condition.STOPPED, "reported by the service");
    }
    if (dead) {
      return finding(Condition.DEAD, "its thread has ended" + error);
    }
    if (last.status() == ServiceStatus.FAILED) {
      return finding(Condition.FAILED, "ended by itself" + error);
    }
    if (lost) {
      return processEnd.isEmpty()
          ? new Finding(Condition.LOST, "its connection broke", true)
          : finding(Condition.LOST, processEnd);
    }
    double silentS = nowS - heardS;
    if (silentS > limits.lostAfter()) {
      return finding(Condition.LOST, "not heard for " + seconds(silentS));
    }
    double runningS = last.callbackRunning().orElse(0.0);
    if (runningS > limits.hungAfter()) {
      return finding(Condition.HUNG, "its callback has been running for " + seconds(runningS));
    }
    if (nowS - spokeS > limits.lostAfter()) { // only the launcher reports; no callback
      return finding(Condition.HUNG, "its thread has not come back for " + seconds(nowS - spokeS));
    }
    if (nowS - spokeS > SILENT_AFTER * last.interval().orElse(USUAL_INTERVAL_S)) {
      return finding(Condition.SILENT, "no report by the service for " + seconds(nowS - spokeS));
    }
    return judgeData(dataTimeoutS, nowS);
  }

  private Finding judgeData(double dataTimeoutS, double nowS) {
    double ageS = last.dataAge().isPresent() ? last.dataAge().getAsDouble() : nowS - sinceS;
    if (dataTimeoutS > 0.0 && last.published().isPresent() && ageS > dataTimeoutS) {
      return finding(Condition.STALLED, "reports, but no data for " + seconds(ageS));
    }
    return finding(Condition.ALIVE, "");
  }

  private static Finding finding(Condition condition, String reason) {
    return new Finding(condition, reason, false);
  }

  private static String seconds(double s) {
    return Math.round(s * 10.0) / 10.0 + " s";
  }
}
