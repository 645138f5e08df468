package org.u2sa.spark;

import java.nio.file.Path;
import org.u2sa.trials.campaign.RunBackend;
import org.u2sa.trials.campaign.RunBackendProvider;
import org.u2sa.trials.campaign.WorkerProcess;

/** Provides backends that use the Spark installation of {@code SPARK_HOME}. */
public final class SparkBackends implements RunBackendProvider {
  @Override
  public RunBackend at(String master, Path directory) {
    SparkMaster address = SparkMaster.of(master);
    SparkHome home = SparkHome.of(System.getenv(SparkHome.VARIABLE));
    ClusterSecrets.check(ClusterProperties.file(System.getenv()), WorkerProcess.javaOptions());
    return new SparkRuns(home, address, address.localAddress(), directory);
  }
}
