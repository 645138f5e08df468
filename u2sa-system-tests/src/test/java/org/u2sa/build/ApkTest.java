package org.u2sa.build;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.FutureTask;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.testkit.NeedsProgram;

/**
 * {@code ./u2sa apk} and the proof of what D8 made, as a user runs them; docs/android-build.md.
 * Takes minutes. Needs Debian's aapt, zipalign, apksigner, enjarify and dexdump, and Maven.
 */
@Tag("android")
@NeedsProgram("python3")
@NeedsProgram("mvn")
@NeedsProgram("aapt")
@NeedsProgram("zipalign")
@NeedsProgram("apksigner")
@NeedsProgram("dexdump")
@NeedsProgram("enjarify")
class ApkTest {
  private static final int BAD_INPUT = 2;
  private static final int CANNOT_BUILD = 3;
  private static final Path ROOT = BuildsAgreeTest.ROOT;

  @TempDir private Path folder;

  /** What a program that ran to its end has said. */
  private record Ended(int exit, String output) {}

  private Ended run(Path path, List<String> command) throws IOException, InterruptedException {
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    if (path != null) {
      builder.environment().put("PATH", path.toString());
      builder.environment().remove("JAVA_HOME");
    }
    builder.environment().put("U2SA_ANDROID_KEYS", folder.resolve("keys").toString());
    Process process = builder.start();
    process.getOutputStream().close();
    String output = new String(process.getInputStream().readAllBytes(), UTF_8);
    return new Ended(process.waitFor(), output);
  }

  private Ended apk(String... arguments) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(ROOT.resolve("u2sa").toString(), "apk"));
    command.addAll(List.of(arguments));
    return run(null, command);
  }

  private Path password() throws IOException {
    Path file = folder.resolve("password");
    Files.writeString(file, "a test's own\n");
    return Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-------"));
  }

  @Test
  void apk_withoutTheTools_namesDebiansPackages() throws Exception {
    String python =
        run(null, List.of("python3", "-c", "import sys; print(sys.executable)")).output().trim();

    Ended ended = run(folder, List.of(python, ROOT.resolve("scripts/android/apk").toString()));

    assertThat(ended.exit()).isEqualTo(CANNOT_BUILD);
    assertThat(ended.output())
        .isEqualTo(
            "apk: found no mvn, no java, no keytool, no aapt, no zipalign, no apksigner;"
                + " expected Debian's programs"
                + " (apt install aapt apksigner maven openjdk-17-jdk-headless zipalign)\n");
  }

  @Test
  void apk_keystoreWithoutPasswordFile_isRefused() throws Exception {
    Ended ended = apk("--keystore", password().toString());

    assertThat(ended.exit()).isEqualTo(BAD_INPUT);
    assertThat(ended.output())
        .isEqualTo(
            "apk: --keystore-password-file is missing;"
                + " a keystore and the file with its password go together\n");
  }

  @Test
  void apk_passwordFileThatOthersMayRead_isRefused() throws Exception {
    Path password = password();
    Files.setPosixFilePermissions(password, PosixFilePermissions.fromString("rw-r--r--"));

    Ended ended =
        apk("--keystore", password.toString(), "--keystore-password-file", password.toString());

    assertThat(ended.exit()).isEqualTo(BAD_INPUT);
    assertThat(ended.output()).contains(password + ": others may read it; expected chmod 600");
  }

  /**
   * The application with a jar of the user's own: D8 takes most of this test's time, so one
   * application shows all.
   */
  @Test
  void apk_ownJarTwice_sameBytesAndAllInsideAndMissionsFlyOnItsDex() throws Exception {
    String jar = OwnServiceJar.in(folder).toString();
    Path one = folder.resolve("one.apk");
    Path two = folder.resolve("two.apk");

    Ended built = apk("--with", jar, "--out", one.toString());

    assertThat(built.exit()).as(built.output()).isZero();
    assertThat(built.output())
        .contains("package: name='org.u2sa.android'", "sdkVersion:'28'", "methods", "debug key");
    assertThat(run(null, List.of("apksigner", "verify", one.toString())).exit()).isZero();
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(folder.resolve("keys"))))
        .isEqualTo("rwx------");
    try (ZipFile archive = new ZipFile(one.toFile())) {
      assertThat(archive.stream().map(ZipEntry::getName))
          .contains(
              "classes.dex",
              "META-INF/services/javax.xml.stream.XMLInputFactory",
              "org/u2sa/core/station/page/index.html")
          .noneMatch(name -> name.endsWith(".class") || name.startsWith("META-INF/maven/"));
      ZipEntry list = archive.getEntry("META-INF/services/" + OwnServiceJar.PROVIDED);
      assertThat(new String(archive.getInputStream(list).readAllBytes(), UTF_8))
          .contains(OwnServiceJar.PROVIDER);
    }

    // dexdump is built on Android's own runtime: it refuses what a phone's would.
    String wanted = "'" + OwnServiceJar.DESCRIPTOR + "'\\|method_ids_size";
    Ended read = run(null, List.of("sh", "-c", "dexdump -f " + one + " | grep \"" + wanted + "\""));
    assertThat(read.output()).contains(OwnServiceJar.DESCRIPTOR);
    assertThat(methods(read.output())).isEqualTo(methodsSaid(built.output()));

    // Meanwhile: the translation back leaves a core idle most of the time.
    FutureTask<Ended> again =
        new FutureTask<>(() -> apk("--no-build", "--with", jar, "--out", two.toString()));
    new Thread(again, "apk").start();
    Ended proven =
        run(
            null,
            List.of(ROOT.resolve("scripts/android/prove-dex").toString(), "--apk", one.toString()));
    assertThat(proven.exit()).as(proven.output()).isZero();
    assertThat(proven.output())
        .contains("cessna, seed 1: same track.csv", "ugv, seed 1: same track.csv");
    assertThat(again.get().exit()).isZero();
    assertThat(Files.mismatch(one, two)).as("first byte that differs").isEqualTo(-1);

    Ended fat = apk("--no-build", "--with", jar, "--with", OwnServiceJar.fat(folder));
    assertThat(fat.exit()).isEqualTo(BAD_INPUT);
    assertThat(fat.output()).contains("expected your own classes only");
  }

  @Test
  void apk_ownJarThatIsNone_isRefusedBeforeTheBuild() throws Exception {
    Path text = Files.writeString(folder.resolve("my.jar"), "no jar");

    Ended none = apk("--with", folder.resolve("absent.jar").toString());
    Ended broken = apk("--with", text.toString());

    assertThat(none.exit()).isEqualTo(BAD_INPUT);
    assertThat(none.output()).contains("absent.jar: no such file");
    assertThat(broken.exit()).isEqualTo(BAD_INPUT);
    assertThat(broken.output()).contains("my.jar: is no jar");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"classes2.dex", "AndroidManifest.xml", "resources.arsc", "lib/arm64-v8a/x.so"})
  void apk_ownJarWithAFileThatAndroidReads_isRefusedBeforeTheBuild(String name) throws Exception {
    Path jar = folder.resolve("my.jar");
    try (ZipOutputStream out = new ZipOutputStream(Files.newOutputStream(jar))) {
      out.putNextEntry(new ZipEntry("mine/Service.class"));
      out.putNextEntry(new ZipEntry(name));
    }

    Ended refused = apk("--with", jar.toString());

    assertThat(refused.exit()).isEqualTo(BAD_INPUT);
    assertThat(refused.output()).contains("my.jar: " + name + " would become part");
  }

  /** The sum of the methods that dexdump finds in the headers of all dex files. */
  private static int methods(String dump) {
    return Pattern.compile("method_ids_size +: (\\d+)")
        .matcher(dump)
        .results()
        .mapToInt(found -> Integer.parseInt(found.group(1)))
        .sum();
  }

  private static int methodsSaid(String report) {
    Matcher said = Pattern.compile("^  (\\d+) methods, ", Pattern.MULTILINE).matcher(report);
    assertThat(said.find()).as(report).isTrue();
    return Integer.parseInt(said.group(1));
  }
}
