package org.u2sa.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageField;

/** Holds docs/missions.md to what the reader does. */
class MissionDocumentTest {
  private static final Path PAGE = Paths.get("../docs/missions.md");

  private static List<String> blocks(String language) throws IOException {
    Matcher matcher =
        Pattern.compile("```" + language + "\n(.*?)```", Pattern.DOTALL)
            .matcher(Files.readString(PAGE));
    List<String> blocks = new ArrayList<>();
    while (matcher.find()) {
      blocks.add(matcher.group(1));
    }
    return blocks;
  }

  @Test
  void examples_allOfThem_load() throws IOException {
    List<String> examples = blocks("xml");

    assertThat(examples).hasSizeGreaterThanOrEqualTo(4);
    for (String example : examples) {
      byte[] bytes = example.getBytes(StandardCharsets.UTF_8);
      Mission mission =
          Mission.parse(
              XmlReader.read(new ByteArrayInputStream(bytes), "docs/missions.md", "mission"),
              StandardTypes.registry(),
              OptionalDouble.of(2.0));
      assertThat(mission.warnings()).isEmpty();
    }
  }

  @Test
  void errors_allOfThem_areThoseOfTheErrorTest() throws IOException {
    String tests =
        Files.readString(Paths.get("src/test/java/org/u2sa/mission/MissionErrorsTest.java"));

    assertThat(blocks("text").get(0).split("\n"))
        .allSatisfy(line -> assertThat(tests).contains(line));
  }

  @Test
  void waypoint_everyFieldThatAFileMayGive_isExplained() throws IOException {
    String page = Files.readString(PAGE);

    assertThat(Waypoint.TYPE.fields())
        .extracting(MessageField::name)
        .filteredOn(name -> !GoalElement.NOT_IN_FILES.contains(name))
        .allSatisfy(name -> assertThat(page).contains("`" + name + "`"));
  }
}
