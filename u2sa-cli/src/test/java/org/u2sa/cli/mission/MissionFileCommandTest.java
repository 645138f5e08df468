package org.u2sa.cli.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.cli.CommandFixture;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.interfaces.units.XmlNumbers;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.mission.Mission;

/** {@code u2sa mission export} and {@code import} on files. */
class MissionFileCommandTest extends CommandFixture {
  private static final String MISSION =
      """
      <mission>
        <home><x>8</x><y>50</y><z>100</z></home>
        <waypoint><next>2</next><x>8</x><y>50.001</y><z unit="ft">900</z><speed unit="kt">9</speed></waypoint>
        <station><next>home</next><x>8.001</x><y>50</y><duration>5</duration></station>
      </mission>
      """;
  private static final String FENCE =
      """
      <fence>
        <keepIn><corner><x>7</x><y>49</y></corner><corner><x>9</x><y>49</y></corner>
          <corner><x>8</x><y>51</y></corner></keepIn>
        <keepOut><centre><x>8</x><y>50.1</y></centre><radius>20</radius></keepOut>
      </fence>
      """;

  @TempDir private Path folder;

  private Path file(String name, String text) throws IOException {
    return Files.writeString(folder.resolve(name), text);
  }

  @ParameterizedTest
  @ValueSource(strings = {"m.plan", "m.waypoints"})
  void exportAndImport_aMission_hasTheSameGoals(String name) throws IOException {
    Path mission = file("mission.xml", MISSION);
    Path other = folder.resolve(name);
    Path back = folder.resolve("back.xml");

    assertThat(u2sa("mission", "export", mission.toString(), "--out", other.toString()))
        .as(err.toString())
        .isEqualTo(ExitCode.DONE);
    assertThat(u2sa("mission", "import", other.toString(), "--out", back.toString()))
        .as(err.toString())
        .isEqualTo(ExitCode.DONE);

    assertThat(Mission.load(back).goals()).isEqualTo(Mission.load(mission).goals());
    assertThat(Mission.load(back).home()).isEqualTo(Mission.load(mission).home());
  }

  @Test
  void export_whatIsLost_isRefusedByNameUnlessItMayBe() throws IOException {
    Path mission = file("mission.xml", MISSION.replace("<z>100</z>", "<z>100</z><psi>90</psi>"));

    assertThat(u2sa("mission", "export", mission.toString())).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("home: psi 90.0 deg");
    assertThat(folder.resolve("mission.plan")).doesNotExist();
    assertThat(u2sa("mission", "export", mission.toString(), "--lossy")).isEqualTo(ExitCode.DONE);
    assertThat(err.toString()).contains("left out: home: psi 90.0 deg");
    assertThat(folder.resolve("mission.plan")).exists();
  }

  @Test
  void exportAndImport_withAFence_takesIt() throws IOException {
    Path mission = file("mission.xml", MISSION);
    Path fence = file("fence.xml", FENCE);
    Path back = folder.resolve("fence2.xml");
    String plan = folder.resolve("mission.plan").toString();

    u2sa("mission", "export", mission.toString(), "--fence", fence.toString());
    assertThat(u2sa("mission", "import", plan, "--out", folder.resolve("m2.xml").toString()))
        .isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("--fence names the file for them");
    assertThat(
            u2sa(
                "mission",
                "import",
                plan,
                "--out",
                folder.resolve("m2.xml").toString(),
                "--fence",
                back.toString()))
        .as(err.toString())
        .isEqualTo(ExitCode.DONE);

    XmlElement read = XmlReader.read(back, "fence");
    assertThat(read.children("keepIn").get(0).children("corner")).hasSize(3);
    XmlElement radius = read.children("keepOut").get(0).child("radius").orElseThrow();
    assertThat(XmlNumbers.converted(radius, "m", "m")).isEqualTo(20.0);
  }

  @Test
  void import_noFileOrNothingToGoTo_isRefused() throws IOException {
    assertThat(u2sa("mission", "import", folder.resolve("none.plan").toString()))
        .isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("none.plan: no such file");
    Path empty = file("empty.plan", "{\"fileType\":\"Plan\",\"mission\":{\"items\":[]}}");
    assertThat(u2sa("mission", "import", empty.toString())).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("contains no position to go to");
  }

  @ParameterizedTest
  @ValueSource(strings = {"1e999999999", "1e40"})
  void import_speedBeyondAllRanges_isRefusedWithItsRange(String speed) throws IOException {
    String item = "{'type':'SimpleItem','command':%d,'frame':0,'doJumpId':%d,'params':[%s]}";
    String items =
        String.format(item, 178, 1, "0," + speed + ",0,0,0,0,0")
            + ","
            + String.format(item, 16, 2, "0,0,0,null,47,8,10");
    Path plan = file("fast.plan", plan(items));
    assertThat(u2sa("mission", "import", plan.toString())).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("fast.plan").doesNotContain("unexpected");
  }

  @Test
  void import_numberOfMillionsOfDigitsOrNoText_isRefused() throws IOException {
    Path digits = file("digits.plan", plan("").replace("400", "4" + "0".repeat(1_000_000)));
    Path bytes = Files.write(folder.resolve("bytes.plan"), new byte[] {-1, -2, '{'});
    for (Path plan : new Path[] {digits, bytes}) {
      assertThat(u2sa("mission", "import", plan.toString())).isEqualTo(ExitCode.BAD_INPUT);
    }
    assertThat(err.toString()).doesNotContain("unexpected");
  }

  private static String plan(String items) {
    String text =
        "{'fileType':'Plan','version':1,'mission':{'version':2,"
            + "'plannedHomePosition':[47,8,400],'items':[%s]}}";
    return String.format(text, items).replace('\'', '"');
  }
}
