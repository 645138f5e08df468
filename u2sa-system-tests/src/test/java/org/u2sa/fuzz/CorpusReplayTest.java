package org.u2sa.fuzz;

import static java.util.concurrent.TimeUnit.SECONDS;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Collections;
import java.util.function.Consumer;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.core.safety.FenceTarget;

/**
 * What fuzzing found worth keeping is tried again by every build: seeds, the inputs that reached
 * new code, and those that once broke something. None may throw what is not documented, or hang.
 */
@Timeout(value = 60, unit = SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class CorpusReplayTest {
  private static final Path CORPUS = Paths.get("src/test/fuzz").toAbsolutePath();

  static Stream<Arguments> targets() {
    return Stream.of(
        target("codec", CodecTarget::fuzzerTestOneInput),
        target("topic", TopicTarget::fuzzerTestOneInput),
        target("mission", MissionTarget::fuzzerTestOneInput),
        target("configuration", ConfigurationTarget::fuzzerTestOneInput),
        target("system", SystemFileTarget::fuzzerTestOneInput),
        target("flightgear", FlightGearLineTarget::fuzzerTestOneInput),
        target("fence", FenceTarget::fuzzerTestOneInput),
        target("users", UsersTarget::fuzzerTestOneInput),
        target("world", WorldTarget::fuzzerTestOneInput));
  }

  private static Arguments target(String name, Consumer<byte[]> target) {
    return Arguments.of(name, target);
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("targets")
  void target_keptCorpus_throwsNothingThatIsNotDocumented(String name, Consumer<byte[]> target)
      throws IOException {
    int inputs = 0;
    try (ZipFile archive = new ZipFile(CORPUS.resolve(name + ".zip").toFile())) {
      for (ZipEntry input : Collections.list(archive.entries())) {
        inputs++;
        try {
          target.accept(archive.getInputStream(input).readAllBytes());
        } catch (RuntimeException | Error e) {
          throw new AssertionError(input + ": " + e, e);
        }
      }
    }
    assertThat(inputs).isGreaterThan(1);
  }
}
