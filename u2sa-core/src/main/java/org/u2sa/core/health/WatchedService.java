package org.u2sa.core.health;

import java.util.ArrayDeque;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import org.u2sa.core.launch.ProcessFailure;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceStatus;

/**
 * One monitored service: its condition and the policy applied to it. Restarts back off; when they
 * do not help, the monitor gives up the service until someone else starts it. A service ordered to
 * stop is left alone.
 */
final class WatchedService {
  /** Kinds of failure that have a policy. */
  private static final Set<Condition> BROKEN =
      EnumSet.of(
          Condition.HUNG, Condition.DEAD, Condition.LOST, Condition.STALLED, Condition.FAILED);

  private static final String GIVEN_UP = "given up";

  /** Longest time between starts that fail for a lack of resources, which others may soon free. */
  private static final double MAX_RETRY_S = 2.0;

  private final String name;
  private final HealthObservation observation;
  private final RestartCount restarts = new RestartCount();
  private HealthObservation.Finding finding =
      new HealthObservation.Finding(Condition.SILENT, "not heard yet", true);
  private double sinceS; // of the finding's condition
  private String action = "";
  private boolean toldToStop;
  private boolean givenUp;
  private String givenUpWords = "";
  private boolean hopeless; // its process rejects its input
  private int shortages; // starts in a row that failed for a lack of resources
  private double shortSinceS = Double.NaN; // time of the first of them; NaN if none
  private double orderedS = Double.NaN; // time of the pending restart order; NaN if none
  private String orderedInstance = ""; // instance that the pending restart is to replace
  private String notStarted = ""; // why the last restart failed; empty if it succeeded
  private String said = ""; // last published condition

  WatchedService(String name, double nowS) {
    this.name = name;
    observation = new HealthObservation(nowS);
    sinceS = nowS;
  }

  void hear(HealthReport report, double nowS) {
    boolean ofReplaced = report.instance().equals(Optional.of(orderedInstance));
    boolean forItself = report.threadAlive().isEmpty();
    if (isPending() && ofReplaced && !(forItself && report.status() == ServiceStatus.RUNNING)) {
      return; // it is ending because it is being replaced
    }
    if (HealthObservation.isOfAFailedStart(report)) {
      endStart(report.lastError().filter(ProcessFailure::isOfInput), nowS);
    }
    if (observation.hear(report, nowS)) {
      toldToStop = false;
      resume();
    }
  }

  /**
   * Ends the waiting for a new instance.
   *
   * @param hopelessness why another start would also fail; empty if it may succeed
   */
  private void endStart(Optional<String> hopelessness, double nowS) {
    if (isPending()) {
      observation.expectAnother(orderedInstance, nowS); // if its order has not been answered yet
      orderedS = Double.NaN;
    }
    hopeless = hopelessness.isPresent();
  }

  /** Discards conclusions from earlier starts. */
  private void resume() {
    givenUp = false;
    hopeless = false;
    shortSinceS = Double.NaN;
    shortages = 0;
  }

  private boolean isPending() {
    return !Double.isNaN(orderedS);
  }

  /** Takes over an earlier monitor's condition, unless this one has already published its own. */
  void remember(ServiceCondition before) {
    if (!said.isEmpty()) {
      return;
    }
    before.instance().ifPresent(observation::remember);
    restarts.remember(before.restarts());
    toldToStop |= before.condition() == Condition.STOPPED;
    if (before.action().contains(GIVEN_UP)) {
      givenUp = true;
      givenUpWords = before.action();
    }
  }

  /** Called when the service was told to stop, so that its absence is not a failure. */
  void toldToStop() {
    toldToStop = true;
  }

  /** Called when somebody else ordered its start or restart. */
  void startedByOthers() {
    toldToStop = false;
    resume();
  }

  void answered(boolean accepted, String reason, double nowS) {
    if (accepted) {
      shortSinceS = Double.NaN;
      shortages = 0;
      if (isPending()) { // otherwise its process has ended
        observation.expectAnother(orderedInstance, nowS);
      }
      return;
    }
    orderedS = Double.NaN;
    action = "restart failed: " + reason;
    notStarted(reason);
    if (ProcessFailure.isOfResources(reason)) {
      restarts.takeBack(); // no instance was started
      shortages++;
      shortSinceS = Double.isNaN(shortSinceS) ? nowS : shortSinceS;
    }
  }

  /** Called when a restart failed, which may have left no instance. */
  void notStarted(String reason) {
    notStarted = reason;
  }

  void excuse(double untilS) {
    observation.excuse(untilS);
  }

  /** Checks the service; returns whether to restart it now. */
  boolean look(MonitorVariables settings, double nowS) {
    HealthObservation.Finding found =
        observation.judge(settings.limits, settings.dataTimeoutS(name), nowS);
    if (toldToStop && found.condition() == Condition.LOST) {
      found = new HealthObservation.Finding(Condition.STOPPED, "ordered to stop", false);
    }
    if (found.condition() == Condition.ALIVE) {
      notStarted = "";
    } else if (found.condition() == Condition.STOPPED && !toldToStop && !notStarted.isEmpty()) {
      found = // it ended in order to be replaced
          new HealthObservation.Finding(
              Condition.FAILED, "its restart failed: " + notStarted, false);
    }
    if (isPending()) {
      boolean shown = found.condition() == Condition.ALIVE;
      if (!shown && nowS - orderedS <= settings.limits.startWithin()) {
        return false; // keep the condition until the new instance reports or is overdue
      }
      orderedS = Double.NaN;
    }
    if (found.condition() != finding.condition()) {
      sinceS = nowS;
      action = "";
    }
    finding = found;
    return BROKEN.contains(found.condition()) && !toldToStop && isDue(settings, nowS);
  }

  private boolean isDue(MonitorVariables settings, double nowS) {
    Policy policy = settings.policyOf(name);
    int before = restarts.within(settings.limits.restartWindow(), nowS);
    if (policy != Policy.RESTART) {
      action = words(policy);
      return false;
    }
    Optional<String> why = givenUp ? Optional.empty() : whyToGiveUp(settings, before, nowS);
    if (why.isPresent()) {
      givenUp = true;
      givenUpWords = words(settings.afterRestarts()) + ", " + GIVEN_UP + why.get();
    }
    if (givenUp) {
      action = givenUpWords;
      return false;
    }
    double delayS = settings.delayS(before);
    if (shortages > 0) {
      delayS = Math.max(delayS, Math.min(settings.delayS(shortages), MAX_RETRY_S));
    }
    if (finding.mayPass()) {
      delayS = Math.max(delayS, settings.limits.reconnectWithin());
    }
    if (nowS - Math.max(sinceS, restarts.lastS()) < delayS) {
      return false;
    }
    action = "restart " + (before + 1) + " of " + settings.limits.restartLimit();
    restarts.add(nowS);
    orderedS = nowS;
    orderedInstance = observation.instance();
    return true;
  }

  private Optional<String> whyToGiveUp(MonitorVariables settings, int before, double nowS) {
    if (hopeless) {
      return Optional.of(": its process rejects its input");
    }
    if (before >= settings.limits.restartLimit()) {
      return Optional.of(" after " + before + " restarts");
    }
    boolean isShortForLong = nowS - shortSinceS > settings.limits.startWithin();
    return isShortForLong ? Optional.of(": no process can be started") : Optional.empty();
  }

  private static String words(Policy policy) {
    return policy == Policy.FAILSAFE ? "failsafe" : "alert";
  }

  /** The condition to publish if it has changed; empty otherwise. */
  Optional<ServiceCondition> news() {
    boolean quiet = said.isEmpty() && finding.condition() == Condition.SILENT;
    String now = finding.condition() + "|" + action + "|" + restarts.total();
    if (quiet || now.equals(said)) {
      return Optional.empty();
    }
    said = now;
    ServiceCondition condition =
        new ServiceCondition()
            .serviceName(name)
            .condition(finding.condition())
            .since(Math.max(0, Clock.micros(sinceS)))
            .reason(finding.reason())
            .action(action)
            .restarts(restarts.total());
    if (!observation.instance().isEmpty()) {
      condition.instance(observation.instance());
    }
    return Optional.of(condition);
  }

  String name() {
    return name;
  }

  private static final class RestartCount {
    private final ArrayDeque<Double> timesS = new ArrayDeque<>();
    private double lastS = Double.NEGATIVE_INFINITY;
    private long total;

    void add(double nowS) {
      timesS.add(nowS);
      lastS = nowS;
      total++;
    }

    /** Withdraws the latest restart; the next one is still delayed from its time. */
    void takeBack() {
      timesS.pollLast();
      total--;
    }

    /** Takes over an earlier monitor's count. */
    void remember(long before) {
      total = Math.max(total, before);
    }

    /** Restarts within the window that ends now. */
    int within(double windowS, double nowS) {
      while (!timesS.isEmpty() && nowS - timesS.peek() > windowS) {
        timesS.poll();
      }
      return timesS.size();
    }

    /** Time of the latest restart [s]; minus infinity if none. */
    double lastS() {
      return lastS;
    }

    long total() {
      return total;
    }
  }
}
