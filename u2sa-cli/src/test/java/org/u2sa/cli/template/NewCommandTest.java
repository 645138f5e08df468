package org.u2sa.cli.template;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.cli.Main;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.interfaces.BadInputException;
import picocli.CommandLine.ParameterException;

class NewCommandTest {
  @TempDir Path folder;
  private Path here;
  private Path templates;
  private NewProject made;

  @BeforeEach
  void here() throws IOException {
    here = Files.createDirectory(folder.resolve("here"));
    templates = Files.createDirectory(folder.resolve("templates"));
    made = new NewProject(here);
  }

  private void refused(String what, String... args) {
    List<String> before = made.files();
    assertThatThrownBy(() -> made.make(args))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining(what);
    assertThat(made.files()).isEqualTo(before);
  }

  private void template(String place, String text) throws IOException {
    Path file = templates.resolve(place);
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }

  @ParameterizedTest
  @CsvSource({
    "class, keyword",
    "Int, keyword",
    "true, keyword",
    "object, java.lang",
    "'', expected letters",
    "3d-sensor, expected letters",
    "x-, expected letters",
    "../up, expected letters",
    "a/b, expected letters",
    "a.b, expected letters",
    "größe, expected letters",
    "two--hyphens, expected letters",
    "waypoint, message Waypoint",
    "settings, uses a class of that name",
    "variables, uses a class of that name",
    "service-context, uses a class of that name",
  })
  void make_badName_isRefused(String name, String why) {
    refused(why, "sensor", name);
  }

  @ParameterizedTest
  @CsvSource({"a..b", "1a", "a.class.b", "java.util", "A B", "a.", "''", "../a", "a/b"})
  void make_badPackage_isRefused(String name) {
    refused("package \"" + name + "\"", "sensor", "depth-gauge", "--package", name);
  }

  @Test
  void make_unknownKind_namesTheNearest() {
    refused("did you mean \"controller\"?", "controler", "rudder");
  }

  @Test
  void make_unknownVehicle_namesTheVehicles() {
    assertThatThrownBy(() -> made.make("vehicle", "x", "--kind", "boot"))
        .isInstanceOf(ParameterException.class)
        .hasMessage(
            "--kind boot: expected one of boat, copter, plane, rover, submarine; did you mean \"boat\"?");
  }

  @Test
  void make_kindOrNameMissing_isRefused() {
    assertThatThrownBy(() -> made.make("sensor"))
        .isInstanceOf(ParameterException.class)
        .hasMessageContaining("NAME");
    assertThatThrownBy(() -> made.make("sensor", "a", "--maven", "--gradle"))
        .isInstanceOf(ParameterException.class);
  }

  @Test
  void run_badInput_isExitCode2() {
    StringWriter err = new StringWriter();
    PrintWriter out = new PrintWriter(new StringWriter());
    assertThat(Main.run(out, new PrintWriter(err), "new", "sensor", "class"))
        .isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).startsWith("u2sa: name \"class\"").hasLineCount(1);
  }

  @Test
  void make_folderExists_isLeftAsItIs() throws IOException {
    Files.createDirectory(here.resolve("depth-gauge"));
    refused("depth-gauge exists", "sensor", "depth-gauge");
    Files.createSymbolicLink(here.resolve("other"), here.resolve("nowhere"));
    refused("other exists", "sensor", "other");
  }

  @Test
  void make_placeIsNoFolder_isRefused() throws IOException {
    Files.writeString(here.resolve("file"), "");
    NewProject inFile = new NewProject(here.resolve("file"));
    assertThatThrownBy(() -> inFile.make("sensor", "depth-gauge"))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("cannot write");
    refused("expected a folder with a pom.xml", "sensor", "depth-gauge", "--into", "file");
    refused("expected a folder with a pom.xml", "sensor", "depth-gauge", "--into", "absent");
  }

  @Test
  void add_serviceThatIsThere_overwritesNothing() throws IOException {
    made.make("sensor", "depth-gauge");
    Path source = here.resolve("depth-gauge/src/main/java/org/example/depthgauge/DepthGauge.java");
    Files.writeString(source, "mine");
    refused("DepthGauge", "actuator", "depth-gauge", "--into", "depth-gauge");
    assertThat(source).hasContent("mine");
    refused("built by maven", "actuator", "fin", "--into", "depth-gauge", "--gradle");
  }

  @Test
  void add_halfOfItCannotBeWritten_leavesNothing() throws IOException {
    Files.writeString(here.resolve("pom.xml"), "<project><groupId>com.example</groupId></project>");
    Files.writeString(here.resolve("src"), "a file where a folder is needed");
    refused("cannot write", "sensor", "depth-gauge", "--into", ".");
  }

  @Test
  void add_foreignProject_takesItsGroupAndSaysWhatItsBuildLacks() throws IOException {
    Files.writeString(here.resolve("pom.xml"), "<project><groupId>com.example</groupId></project>");
    made.make("sensor", "depth-gauge", "--into", ".");
    assertThat(made.files()).contains("src/main/java/com/example/DepthGauge.java");
    assertThat(made.told()).contains("does not use U2SA yet");
    assertThat(here.resolve("pom.xml"))
        .hasContent("<project><groupId>com.example</groupId></project>");
  }

  @Test
  void add_linkOutOfTheProject_isRefused() throws IOException {
    made.make("sensor", "depth-gauge");
    Path project = here.resolve("depth-gauge");
    Path outside = Files.createDirectory(folder.resolve("outside"));
    NewProject linked = new NewProject(Files.createDirectory(folder.resolve("linked")));
    Path link = folder.resolve("linked");
    Files.copy(project.resolve("pom.xml"), link.resolve("pom.xml"));
    Files.createSymbolicLink(link.resolve("src"), outside);
    assertThatThrownBy(() -> linked.make("sensor", "fin"))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("leads out of");
    assertThat(outside).isEmptyDirectory();
    assertThat(linked.files()).containsExactly("pom.xml", "src");
  }

  @Test
  void list_organisationsTemplates_comeFirstAndSayWhere() throws IOException {
    template("sensor/about.txt", "Our sensor.\n");
    template("radio/about.txt", "Our radio.\n\nSwitch {{name}} on.\n");
    made.make("--list", "--templates", templates.toString());
    assertThat(made.told())
        .contains("Our sensor. (" + templates + ")", "Our radio. (" + templates + ")")
        .contains("vehicle", "(U2SA)")
        .doesNotContain("A sensor that measures");
  }

  @Test
  void make_organisationsTemplate_fillsPlacesAndTexts() throws IOException {
    template("radio/about.txt", "Our radio.\n\nSwitch {{words}} on.\n");
    template("radio/{{package}}/{{Name}}.txt", "{{name}} {{NAME}} {{file}} {{package}}");
    template("maven/pom.xml", "<project>ours</project>");
    Files.write(templates.resolve("radio/picture"), new byte[] {'{', '{', 'x', '}', '}', 0});
    made.make("radio", "long-range", "--templates", templates.toString(), "--package", "a.b");
    Path project = here.resolve("long-range");
    assertThat(project.resolve("a/b/LongRange.txt"))
        .hasContent("longRange LONG RANGE long-range a.b");
    assertThat(project.resolve("pom.xml")).hasContent("<project>ours</project>");
    assertThat(project.resolve("picture"))
        .hasBinaryContent(new byte[] {'{', '{', 'x', '}', '}', 0});
    assertThat(made.told()).contains("Switch long range on.");
  }

  @Test
  void make_placeholderMistyped_namesFileAndLine() throws IOException {
    template("radio/about.txt", "Our radio.\n");
    template("radio/a.txt", "first\nsecond {{packge}}\n");
    refused(
        "radio/a.txt, line 2: unknown placeholder {{packge}}",
        "radio",
        "x",
        "--templates",
        templates.toString());
  }

  @Test
  void make_placeOutsideOfTheProject_isRefused() throws IOException {
    template("radio/about.txt", "Our radio.\n");
    template("radio/{{dot}}{{dot}}/evil", "out");
    refused("leads out of", "radio", "x", "--templates", templates.toString());
    assertThat(folder.resolve("here/evil")).doesNotExist();
  }

  @Test
  void make_templateTooLargeOrALink_isRefused() throws IOException {
    template("radio/about.txt", "Our radio.\n");
    Files.write(templates.resolve("radio/large"), new byte[(4 << 20) + 1]);
    refused("expected at most", "radio", "x", "--templates", templates.toString());
    Files.delete(templates.resolve("radio/large"));
    Files.createSymbolicLink(templates.resolve("radio/link"), folder);
    refused("radio/link: expected a file", "radio", "x", "--templates", templates.toString());
  }

  @Test
  void make_templatesInAJar_areFound() throws IOException {
    Path jar = folder.resolve("ours.jar");
    zip(jar, "radio/about.txt", "Our radio.\n", "radio/{{Name}}.txt", "{{words}}");
    made.make("radio", "long-range", "--templates", jar.toString());
    assertThat(here.resolve("long-range/LongRange.txt")).hasContent("long range");
  }

  @Test
  void make_templatesThatAreNoneOrHostile_areRefused() throws IOException {
    Path jar = folder.resolve("evil.jar");
    zip(jar, "radio/about.txt", "Our radio.\n", "radio/../../../evil", "out");
    refused("evil.jar: expected a folder or a jar", "radio", "x", "--templates", jar.toString());
    Files.writeString(jar, "no jar");
    refused("expected a folder or a jar", "radio", "x", "--templates", jar.toString());
    refused("expected a folder or a jar", "radio", "x", "--templates", folder + "/absent");
  }

  private static void zip(Path jar, String... placesAndTexts) throws IOException {
    try (ZipOutputStream out = new ZipOutputStream(Files.newOutputStream(jar))) {
      for (int i = 0; i < placesAndTexts.length; i += 2) {
        out.putNextEntry(new ZipEntry(placesAndTexts[i]));
        out.write(placesAndTexts[i + 1].getBytes(java.nio.charset.StandardCharsets.UTF_8));
      }
    }
  }
}
