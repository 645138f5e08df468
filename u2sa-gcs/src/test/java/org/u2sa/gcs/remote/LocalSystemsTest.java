package org.u2sa.gcs.remote;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.mqtt.AccountFolders;

class LocalSystemsTest {
  @TempDir private Path directory;
  private final List<String> told = new ArrayList<>();

  private LocalSystems systems() {
    return new LocalSystems(new AccountFolders("", directory.toString()));
  }

  private LocalSystems.Announcement announce(String systemId, int port) {
    return systems()
        .announce(systemId, Optional.of(new InetSocketAddress("127.0.0.1", port)), told::add);
  }

  @Test
  void theOnly_oneSystemAtAnotherPort_isFoundUntilItEnds() {
    LocalSystems.Announcement boat = announce("boat", 40_001);

    assertThat(systems().theOnly(Optional.empty()))
        .hasValue(BrokerAddress.parse("localhost:40001"));
    assertThat(systems().theOnly(Optional.of("cessna"))).isEmpty();

    boat.close();
    assertThat(systems().theOnly(Optional.empty())).isEmpty();
    assertThat(told).isEmpty();
  }

  @Test
  void theOnly_severalSystems_needsTheOneThatIsMeant() {
    announce("boat", 40_001);
    announce("cessna", 1883);

    assertThatThrownBy(() -> systems().theOnly(Optional.empty()))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("boat at localhost:40001, cessna at localhost:1883")
        .hasMessageContaining("--system");
    assertThat(systems().theOnly(Optional.of("boat")))
        .hasValue(BrokerAddress.parse("localhost:40001"));
  }

  @Test
  void running_processThatEndedWithoutAWord_isForgotten() throws IOException {
    announce("boat", 40_001).close();
    Path left = directory.resolve(".u2sa/run/999999999-1883"); // above any process's number
    Files.writeString(left, "ghost localhost:1883 long-ago");

    assertThat(systems().running()).isEmpty();
    assertThat(left).doesNotExist();
  }

  @Test
  void running_numberOfAnotherProcessNow_isForgotten() throws IOException {
    announce("boat", 40_001);
    Path ours = directory.resolve(".u2sa/run/" + ProcessHandle.current().pid() + "-40001");
    String entry = Files.readString(ours);
    Path left = ours.resolveSibling(ProcessHandle.current().pid() + "-1883");
    Files.writeString(left, entry.replace("boat localhost:40001", "ghost localhost:1883") + "9");

    assertThat(systems().theOnly(Optional.empty()))
        .hasValue(BrokerAddress.parse("localhost:40001"));
    assertThat(left).doesNotExist();
    assertThat(ours).exists();
  }

  /** A folder with something in it: it can be neither read as a file nor deleted. */
  private void makeStubborn(long pid, int port) throws IOException {
    Files.createDirectories(directory.resolve(".u2sa/run/" + pid + "-" + port + "/inside"));
  }

  @Test
  void running_leftFileCannotBeDeleted_isIgnored() throws IOException {
    announce("boat", 40_001);
    makeStubborn(999_999_999L, 1883);

    assertThat(systems().running()).hasSize(1);
    assertThat(systems().brokers(Optional.empty(), told::add)).hasSize(1);
    assertThat(told).isEmpty();
  }

  @Test
  void running_oneFileCannotBeRead_isToldAndTheOthersAreFound() throws IOException {
    announce("boat", 40_001);
    makeStubborn(ProcessHandle.current().pid(), 1883);

    assertThat(systems().running()).hasSize(1);
    assertThat(systems().brokers(Optional.empty(), told::add)).hasSize(1);
    assertThat(told).singleElement().asString().contains("-1883");
  }

  @Test
  void running_nothingCanBeRead_isAFailure() throws IOException {
    announce("boat", 40_001).close();
    makeStubborn(ProcessHandle.current().pid(), 1883);

    assertThatThrownBy(() -> systems().running())
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("-1883")
        .hasMessageContaining("--broker");
    assertThat(systems().brokers(Optional.empty(), told::add)).isEmpty();
    assertThat(told).hasSize(1);
  }

  @Test
  void running_announcedWithAnotherRuntimeFolder_isFoundOnceByBoth() throws IOException {
    Path runtime = Files.createDirectory(directory.resolve("runtime"));
    LocalSystems session =
        new LocalSystems(new AccountFolders(runtime.toString(), directory.toString()));
    session.announce("boat", Optional.of(new InetSocketAddress("127.0.0.1", 40_001)), told::add);

    assertThat(systems().running()).hasSize(1);
    assertThat(session.running()).hasSize(1);
    Files.delete(directory.resolve(".u2sa/run/" + ProcessHandle.current().pid() + "-40001"));
    assertThat(session.running()).hasSize(1);
  }

  @Test
  void announce_folderCannotBeMade_isToldAndTheSystemRunsOn() throws IOException {
    Files.writeString(directory.resolve(".u2sa"), "a file");

    announce("boat", 40_001).close();

    assertThat(told).singleElement().asString().contains("--broker localhost:40001");
  }

  @Test
  void announce_noBroker_isNotAnnounced() {
    systems().announce("boat", Optional.empty(), told::add).close();

    assertThat(systems().running()).isEmpty();
    assertThat(told).isEmpty();
  }
}
