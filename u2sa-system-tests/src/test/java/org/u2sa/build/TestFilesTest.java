package org.u2sa.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import org.junit.jupiter.api.Test;

/** Tests that pass in one build pass in the other: neither gives them what the other does not. */
class TestFilesTest {
  @Test
  void tests_asTheyStand_relyOnNeitherBuild() throws IOException {
    assertThat(TestFiles.ofOneBuildOnly(BuildsAgreeTest.ROOT)).isEmpty();
  }
}
