package org.u2sa.recorder;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.recorder.mcap.record.McapAttachment;

class RunFilesTest {
  @TempDir private Path folder;
  private final RecordingFacts facts = new RecordingFacts();

  private Path write(String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    return Files.writeString(file, text);
  }

  private static List<String> fileNames(List<McapAttachment> attachments) {
    return attachments.stream().map(each -> Path.of(each.name()).getFileName().toString()).toList();
  }

  @Test
  void system_configurationThatNamesFiles_attachesXmlAndMapsOnceAndNoPasswords()
      throws IOException {
    Path system = write("system.xml", "<system/>");
    write("mission.xml", "<mission/>");
    write("ground.asc", "ncols 2");
    write("user.password", "secret");
    Path manager =
        write(
            "Manager.xml",
            "<configuration><variable name=\"MISSION\" value=\"mission.xml\"/>"
                + "<variable name=\"PASSWORD FILE\" value=\"user.password\"/>"
                + "<variable name=\"TERRAIN\" value=\"ground.asc\"/>"
                + "<variable name=\"FENCE\" value=\"missing.xml\"/></configuration>");

    new RunFiles(facts).system(system, List.of(manager, manager));

    List<RecordingFacts.Missing> missing = new ArrayList<>();
    assertThat(fileNames(facts.attachments(0, missing)))
        .containsExactly("system.xml", "Manager.xml", "mission.xml", "ground.asc");
    assertThat(missing).isEmpty();
  }

  @Test
  void logs_writtenLater_areAttachedAtTheEnd() throws IOException {
    new RunFiles(facts).logs(folder.resolve("logs"));
    assertThat(facts.attachmentsOfEnd(0, new ArrayList<>())).isEmpty();

    write("logs/Control.log", "late");
    write("logs/recording.mcap", "none");
    assertThat(facts.attachmentsOfEnd(0, new ArrayList<>()))
        .extracting(McapAttachment::name)
        .containsExactly("logs/Control.log");
  }
}
