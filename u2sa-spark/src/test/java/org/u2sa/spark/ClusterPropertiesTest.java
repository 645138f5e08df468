package org.u2sa.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;

/** Where the secret of a cluster may be. */
class ClusterPropertiesTest {
  @TempDir private Path folder;

  private Path file(String mode) throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("spark-defaults.conf"),
            "# ours\nspark.authenticate true\nspark.authenticate.secret  abc\n");
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString(mode));
    return file;
  }

  @Test
  void file_ofTheEnvironment_isWhereSparkLooks() {
    assertThat(ClusterProperties.file(Map.of("SPARK_HOME", "/opt/spark")))
        .isEqualTo(Path.of("/opt/spark/conf/spark-defaults.conf"));
    assertThat(
            ClusterProperties.file(
                Map.of("SPARK_HOME", "/opt/spark", "SPARK_CONF_DIR", "/etc/spark")))
        .isEqualTo(Path.of("/etc/spark/spark-defaults.conf"));
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void read_fileOfTheOwnerAlone_hasItsSettings() throws IOException {
    Path file = file("rw-------");
    ClusterSecrets.check(file, List.of("-Xmx1g", "-Dspark.cores.max=4"));

    assertThat(ClusterProperties.read(file))
        .containsEntry("spark.authenticate", "true")
        .containsEntry("spark.authenticate.secret", "abc");
  }

  @Test
  void read_noFile_isEmpty() throws IOException {
    Path absent = folder.resolve("absent");
    ClusterSecrets.check(absent, List.of());
    assertThat(ClusterProperties.read(absent)).isEmpty();
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void check_secretInAFileOpenToOthers_isRefused() throws IOException {
    Path file = file("rw-r--r--");

    assertThatThrownBy(() -> ClusterSecrets.check(file, List.of()))
        .isInstanceOf(BadInputException.class)
        .hasMessage(
            file + " has a secret, and users other than its owner may read it; chmod 600 it");
  }

  @Test
  void check_secretOnTheCommandLine_isRefusedUnquoted() {
    Path file = folder.resolve("spark-defaults.conf");

    assertThatThrownBy(
            () -> ClusterSecrets.check(file, List.of("-Dspark.authenticate.secret=S3CRET")))
        .isInstanceOf(BadInputException.class)
        .hasMessageStartingWith(
            "-Dspark.authenticate.secret in U2SA_JAVA_OPTS: every account of this host can read it; write it into "
                + file)
        .hasMessageNotContaining("S3CRET");
  }
}
