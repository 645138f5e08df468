package org.u2sa.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.mqtt.ClientIds;

/** How the process of a service is started. */
class ProcessCommandTest {
  private static ProcessBuilder process(boolean restart, boolean besideManager) {
    return new ServiceProcesses.ProcessCommand(
            Path.of("system.xml"), Path.of("logs"), 1, List.of("Lidar:RATE=5"), besideManager)
        .of("Lidar", restart);
  }

  @Test
  void of_everyProcess_sharesTheRunWithThisOneWithoutShowingItToOthers() {
    ProcessBuilder process = process(false, true);

    assertThat(process.environment()).containsEntry(ClientIds.ENVIRONMENT, ClientIds.run());
    assertThat(process.command()).noneMatch(word -> word.contains(ClientIds.run()));
  }

  @Test
  void of_restartAndManagerHere_areOptions() {
    assertThat(process(false, false).command()).doesNotContain("--restart", "--beside-manager");
    assertThat(process(true, true).command())
        .contains("--only", "Lidar", "--supervised", "--restart", "--beside-manager")
        .endsWith("--set", "Lidar:RATE=5");
  }
}
