package org.u2sa.chaos;

import java.util.Optional;
import org.u2sa.interfaces.time.Clock;

/** Awaits on the side that somebody tells that a service is gone. */
final class Noticing extends Thread {
  /** Who watches over the others: that it is gone, it cannot tell, but its successor shows. */
  private static final String MONITOR = "HealthMonitor";

  private final Watch watch;
  private final Patience patience;
  private final String victim;
  private final String instance;
  private final long began;
  private final double withinS;
  private volatile double afterS = Double.NaN;

  /**
   * @param instance of the victim when the fault began
   * @param began when [µs]
   * @param withinS how long to wait
   */
  Noticing(
      Watch watch, Patience patience, String victim, String instance, long began, double withinS) {
    super("chaos-noticing");
    this.watch = watch;
    this.patience = patience;
    this.victim = victim;
    this.instance = instance;
    this.began = began;
    this.withinS = withinS;
    setDaemon(true);
  }

  @Override
  public void run() {
    try {
      if (patience.await(withinS, this::isNoticed)) {
        afterS = Clock.seconds(patience.clock().micros() - began);
      }
    } catch (InterruptedException e) {
      interrupt();
    }
  }

  private boolean isNoticed() {
    boolean replaced = !watch.instance(victim).equals(instance);
    return watch.firstTrouble(victim, began).isPresent() || victim.equals(MONITOR) && replaced;
  }

  /** After how long it was told [s]; empty if never. */
  Optional<Double> afterS() throws InterruptedException {
    join();
    return Double.isNaN(afterS) ? Optional.empty() : Optional.of(afterS);
  }
}
