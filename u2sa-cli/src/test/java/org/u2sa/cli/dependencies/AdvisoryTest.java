package org.u2sa.cli.dependencies;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.LocalDate;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class AdvisoryTest {
  private static DependencyData.Library netty(String version) {
    return new DependencyData.Library(
        "io.netty:netty-codec", version, LocalDate.EPOCH, "run", "Apache-2.0");
  }

  @ParameterizedTest
  @CsvSource({
    "io.netty:netty-codec, 4.1.0, 4.1.133, 4.1.93.Final, true",
    "io.netty:netty-codec, 4.1.0, 4.1.133, 4.1.132.Final, true",
    "io.netty:netty-codec, 4.1.0, 4.1.133, 4.1.133.Final, false",
    "io.netty:netty-codec, 4.1.0, 4.1.133, 4.1.140.Final, false",
    "io.netty:netty-codec, 4.1.91, 4.1.118, 4.1.90.Final, false",
    "io.netty:netty-codec, 4.1.0, never, 4.1.140.Final, true",
    "io.netty:*, 4.1.0, 4.1.136, 4.1.135.Final, true",
    "io.netty:netty-codec-mqtt, 4.1.0, 4.1.136, 4.1.135.Final, false",
    "io.net:*, 4.1.0, 4.1.136, 4.1.135.Final, false",
    "io.netty:netty-codec, 4.1, 4.1.9, 4.1.10, false"
  })
  void affects_versionAndRange_asRangesSay(
      String library, String introduced, String fixed, String version, boolean expected) {
    DependencyData.Advisory advisory =
        new DependencyData.Advisory("CVE-1", library, introduced, fixed, true, "what");

    assertThat(advisory.affects(netty(version))).isEqualTo(expected);
  }
}
