package org.u2sa.scenarios.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.u2sa.spark.RunBackendContract;

/** Processes of this machine. */
class WorkerPoolTest extends RunBackendContract {
  @Override
  protected RunBackend backend(Path directory) {
    return new WorkerPool(2, directory);
  }

  @Test
  void inWords_anyNumber_isCounted() {
    assertThat(new WorkerPool(1, Path.of("x")).inWords()).isEqualTo("1 process");
    assertThat(new WorkerPool(3, Path.of("x")).inWords()).isEqualTo("3 processes");
  }
}
