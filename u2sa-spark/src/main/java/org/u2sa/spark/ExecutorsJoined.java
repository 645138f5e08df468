package org.u2sa.spark;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.scheduler.SparkListener;
import org.apache.spark.scheduler.SparkListenerExecutorAdded;

/** Waits for the first executor, because a cluster without a free one would block a campaign. */
final class ExecutorsJoined extends SparkListener {
  private static final long WITHIN_S = 60;

  private final CountDownLatch joined = new CountDownLatch(1);

  private ExecutorsJoined() {}

  /**
   * Blocks until the cluster has allocated a core.
   *
   * @throws IllegalStateException if none is allocated within a minute
   */
  static void await(JavaSparkContext spark) {
    if (spark.isLocal()) {
      return;
    }
    ExecutorsJoined listener = new ExecutorsJoined();
    spark.sc().addSparkListener(listener);
    boolean isThereAlready =
        spark.sc().statusTracker().getExecutorInfos().length > 1; // the driver counts as one
    try {
      if (!isThereAlready && !listener.joined.await(WITHIN_S, TimeUnit.SECONDS)) {
        throw new IllegalStateException(
            spark.master()
                + " has allocated no core within "
                + WITHIN_S
                + " s: it has no worker with a free core and "
                + spark.getConf().get("spark.executor.memory", "1g")
                + " of memory, its workers cannot reach this host, or they require a secret (spark.authenticate)");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("interrupted while waiting for the cluster", e);
    } finally {
      spark.sc().removeSparkListener(listener);
    }
  }

  @Override
  public void onExecutorAdded(SparkListenerExecutorAdded event) {
    joined.countDown();
  }
}
