package org.u2sa.recorder.execution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.entry;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.InferredValue;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.recorder.Recorder;
import org.u2sa.recorder.execution.AmplifierRun.Amplifier;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.service.ServiceContext;

/** What a recording of somebody else says must not reach beyond the folder of its execution. */
class ForeignRecordingTest {
  private static final byte[] CONFIGURATION =
      "<configuration><variable name=\"WORLD\" type=\"string\" value=\"x.xml\"/></configuration>"
          .getBytes(StandardCharsets.UTF_8);
  private static final byte[] CONTENT = "<world/>".getBytes(StandardCharsets.UTF_8);

  @TempDir Path outside;

  private Path folder;
  private final Map<String, String> texts = new HashMap<>();
  private final Map<String, byte[]> files = new HashMap<>();

  @BeforeEach
  void begin() throws IOException {
    folder = Files.createDirectory(outside.resolve("folder"));
    texts.put(ExecutionStart.SYSTEM, "rover");
    texts.put(ExecutionStart.SEED, "1");
    texts.put(ExecutionStart.CONFIGURATION_NAME, "config/Amplifier.xml");
    files.put(ExecutionStart.CONFIGURATION, CONFIGURATION);
  }

  private ServiceContext context() throws IOException {
    return new RestoredInputs(new ExecutionStart(texts, files), folder)
        .context(MessageTypes.discovered());
  }

  private TreeSet<String> filesBelow(Path top) throws IOException {
    TreeSet<String> names = new TreeSet<>();
    try (Stream<Path> all = Files.walk(top)) {
      all.filter(Files::isRegularFile)
          .forEach(file -> names.add(top.relativize(file).toString().replace('\\', '/')));
    }
    return names;
  }

  private void variable(String name, String value) {
    texts.put(ExecutionStart.OF_VARIABLE + name, value);
    files.put(ExecutionStart.OF_VARIABLE + name, CONTENT);
  }

  @Test
  void context_variableNamesFileInTheFolder_isLaidOutThere() throws IOException {
    variable("WORLD", "../../worlds/x.xml");
    ServiceContext context = context();
    assertThat(context.configuration().overrides()).doesNotContainKey("WORLD");
    assertThat(context.configuration().resolve("../../worlds/x.xml")).hasBinaryContent(CONTENT);
    assertThat(filesBelow(folder)).contains("1/2/3/4/worlds/x.xml");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "../../../../../../../x.xml",
        "../../../../../../../folder2/x.xml",
        "../../../../../../../../../../../x.xml"
      })
  void context_variableNamesFileOutside_isLaidOutInTheFolder(String value) throws IOException {
    variable("WORLD", value);
    ServiceContext context = context();
    Path laidOut = folder.resolve("files").resolve("WORLD").resolve("x.xml");
    assertThat(context.configuration().overrides()).doesNotContainKey("WORLD");
    assertThat(context.configuration().resolve(value)).isEqualTo(laidOut);
    assertThat(laidOut).hasBinaryContent(CONTENT);
    assertThat(filesBelow(outside)).allMatch(name -> name.startsWith("folder/"));
  }

  @Test
  void context_variableNamesAbsoluteFile_isLaidOutInTheFolder() throws IOException {
    variable("WORLD", outside.resolve("evil.xml").toString());
    context();
    assertThat(folder.resolve("files/WORLD/evil.xml")).hasBinaryContent(CONTENT);
    assertThat(outside.resolve("evil.xml")).doesNotExist();
  }

  @Test
  void context_configurationInMemory_findsItsFileInTheFolder() throws IOException {
    files.remove(ExecutionStart.CONFIGURATION);
    variable("WORLD", "x.xml");
    ServiceContext context = context();
    assertThat(context.configuration().resolve("x.xml"))
        .isEqualTo(folder.resolve("files/WORLD/x.xml"));
    assertThat(folder.resolve("files/WORLD/x.xml")).hasBinaryContent(CONTENT);
  }

  @ParameterizedTest
  @ValueSource(strings = {"..", "../..", "a\\..", ".", "a\0b"})
  void context_stateFileWithoutAName_isRefused(String name) {
    files.put(ExecutionStart.OF_STATE + name, CONTENT);
    assertThatThrownBy(this::context)
        .isInstanceOf(McapException.class)
        .hasMessageContaining("a file cannot have the name \"state/");
  }

  @Test
  void context_stateFileInFolders_isLaidOutByItsLastName() throws IOException {
    files.put(ExecutionStart.OF_STATE + "../../evil\\Amplifier.progress", CONTENT);
    context();
    assertThat(folder.resolve("logs/Amplifier.progress")).hasBinaryContent(CONTENT);
    assertThat(filesBelow(outside)).allMatch(name -> name.startsWith("folder/"));
  }

  @Test
  void context_configurationNamedAsAFolder_isRefused() {
    texts.put(ExecutionStart.CONFIGURATION_NAME, "..");
    assertThatThrownBy(this::context)
        .isInstanceOf(McapException.class)
        .hasMessage("a file cannot have the name \"..\"");
  }

  @Test
  void context_overriddenVariable_isOverriddenAgain() throws IOException {
    InferredValue text = new InferredValue("007", 7);
    texts.put(ExecutionStart.OVERRIDE + "GAIN", ExecutionStart.typed(2.5));
    texts.put(ExecutionStart.OVERRIDE + "NAME", ExecutionStart.typed(text));
    assertThat(context().configuration().overrides())
        .containsOnly(entry("GAIN", 2.5), entry("NAME", text));
  }

  @Test
  void context_toleratedVariables_areToleratedAgain() throws IOException {
    texts.put(ExecutionStart.TOLERATED, "WORLD\tOTHER");
    assertThat(context().configuration().tolerated()).containsExactlyInAnyOrder("WORLD", "OTHER");
    texts.put(ExecutionStart.TOLERATED, "");
    assertThat(context().configuration().tolerated()).isEmpty();
  }

  @Test
  void rerun_logPathElsewhere_logsIntoTheFolder() throws Exception {
    AmplifierRun run = new AmplifierRun(outside);
    run.recordInLockstep(Amplifier::new);
    Path elsewhere = Files.createDirectory(outside.resolve("elsewhere"));
    rerunThatLogs(run, "LOG PATH", elsewhere.toString());
    assertThat(elsewhere).isEmptyDirectory();
  }

  @Test
  void rerun_service_mayNotWriteFilesThatItsConfigurationNames() throws Exception {
    AmplifierRun run = new AmplifierRun(outside);
    run.recordInLockstep(Amplifier::new);
    List<Boolean> writes = new ArrayList<>();
    run.rerun(
        context -> {
          writes.add(context.execution().writesNamedFiles());
          return new Amplifier(context);
        });
    assertThat(writes).containsExactly(false);
  }

  private static void rerunThatLogs(AmplifierRun run, String variable, String value)
      throws Exception {
    ExecutionStart start = ExecutionStart.all(run.files).get("Amplifier");
    Map<String, String> changed = new HashMap<>(start.texts());
    changed.put(ExecutionStart.OVERRIDE + variable, ExecutionStart.typed(value));
    new Rerun(run.files, "Amplifier", new ExecutionStart(changed, start.files()))
        .run(
            context -> {
              Amplifier service = new Amplifier(context);
              service.log("somewhere");
              return service;
            });
  }

  @Test
  void rerun_recordingNamesARecorder_isRefusedBeforeItWritesAnything() throws Exception {
    AmplifierRun run = new AmplifierRun(outside);
    run.recordInLockstep(Amplifier::new);
    Path evil = outside.resolve("evil.mcap");
    texts.put(ExecutionStart.CLASS, Recorder.class.getName());
    texts.put(ExecutionStart.OVERRIDE + "FILE", ExecutionStart.typed(evil.toString()));
    files.clear();
    Rerun rerun = new Rerun(run.files, "Amplifier", new ExecutionStart(texts, files));
    assertThatThrownBy(() -> rerun.run(Recorder::new))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("OBSERVER");
    assertThat(evil).doesNotExist();
  }
}
