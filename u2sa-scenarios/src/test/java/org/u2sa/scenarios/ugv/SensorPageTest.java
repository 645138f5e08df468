package org.u2sa.scenarios.ugv;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.testkit.Repository;

/** The system files of docs/drivers/sensors.md start as they stand there, without their devices. */
class SensorPageTest {
  private static final Pattern FILE =
      Pattern.compile("<!-- file: (\\S+) -->\n```xml\n(.*?)```", Pattern.DOTALL);

  @TempDir Path directory;

  @BeforeEach
  void write() throws Exception {
    Path page = Repository.root().resolve("docs/drivers/sensors.md");
    Matcher files = FILE.matcher(Files.readString(page, UTF_8));
    while (files.find()) {
      Files.writeString(directory.resolve(files.group(1)), files.group(2), UTF_8);
    }
  }

  private String log(String service) throws Exception {
    return Files.readString(directory.resolve("logs/" + service + ".log"), UTF_8);
  }

  private void run(String file, int services) throws Exception {
    LockstepClock clock = new LockstepClock();
    LaunchOptions options =
        new LaunchOptions()
            .clock(clock)
            .logDirectory(directory.resolve("logs"))
            .override("CommunicationManager", "BROKER", "none");
    try (RunningSystem running =
        RunningSystem.start(SystemFile.read(directory.resolve(file)), options)) {
      clock.advance(Clock.micros(4.0));
      assertThat(running.isRunning()).isTrue();
      assertThat(running.services()).hasSize(services);
    }
  }

  @ParameterizedTest
  @CsvSource({"system.xml, 7", "more.xml, 4"})
  void systemFile_ofThePage_starts(String file, int services) throws Exception {
    run(file, services);
  }

  @Test
  void systemFile_withoutDevices_eachServiceSaysSo() throws Exception {
    run("system.xml", 7);
    assertThat(log("Port")).contains("the thruster is lost");
    assertThat(log("DepthSensor")).contains("the depth gauge is lost");
    assertThat(log("WaterSpeedSensor")).contains("the velocity log is lost");
  }
}
