package org.u2sa.spark;

import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.u2sa.trials.campaign.RunBackend;

/** Spark with two cores of this machine. Needs SPARK_HOME. */
@Tag("spark")
class SparkRunsTest extends RunBackendContract {
  @Override
  protected RunBackend backend(Path directory) {
    return new SparkBackends().at("local[2]", directory);
  }
}
