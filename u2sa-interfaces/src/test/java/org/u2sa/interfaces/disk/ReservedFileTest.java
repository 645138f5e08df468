package org.u2sa.interfaces.disk;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ReservedFileTest {
  private static final int ROOM = 10_000;

  @TempDir private Path folder;

  private Path file() {
    return folder.resolve("state");
  }

  private Path reserve() {
    return folder.resolve("state.reserve");
  }

  private static byte[] text(char letter, int length) {
    return String.valueOf(letter).repeat(length).getBytes(UTF_8);
  }

  /** Leaves no room for another file. */
  private void refuseOtherFiles() throws IOException {
    Files.createDirectories(folder.resolve("state.tmp/in the way"));
  }

  @Test
  void replace_withRoom_isAsLongAsItsTextAndReservesMore() throws IOException {
    ReservedFile reserved = new ReservedFile(file(), ROOM);
    reserved.replace(text('a', 100));
    assertThat(Files.size(reserve())).isEqualTo(ROOM);
    reserved.replace(text('b', 2 * ROOM));

    assertThat(file()).hasBinaryContent(text('b', 2 * ROOM));
    assertThat(Files.size(reserve())).isEqualTo(4 * ROOM);
  }

  @Test
  void replace_noRoom_usesTheReserveAndKeepsItsSize() throws IOException {
    ReservedFile reserved = new ReservedFile(file(), ROOM);
    reserved.replace(text('a', 100));
    refuseOtherFiles();
    for (int length : new int[] {5_000, 200, 7_000}) {
      reserved.replace(text('b', length));

      assertThat(Files.readString(file()))
          .isEqualTo("b".repeat(length) + "\n".repeat(ROOM - length));
      assertThat(reserve()).doesNotExist();
    }
    Files.delete(folder.resolve("state.tmp/in the way"));
    Files.delete(folder.resolve("state.tmp"));
    reserved.replace(text('c', 100));

    assertThat(file()).hasBinaryContent(text('c', 100));
    assertThat(Files.size(reserve())).as("again").isEqualTo(ROOM);
  }

  @Test
  void replace_noRoomAndNoFile_failsAndLeavesNone() throws IOException {
    ReservedFile reserved = new ReservedFile(file(), 0);
    refuseOtherFiles();

    assertThatThrownBy(() -> reserved.replace(text('a', 100))).isInstanceOf(IOException.class);

    assertThat(file()).doesNotExist();
  }

  @Test
  void delete_removesTheReserve() throws IOException {
    ReservedFile reserved = new ReservedFile(file(), ROOM);
    reserved.replace(text('a', 100));
    reserved.delete();

    assertThat(folder).isEmptyDirectory();
  }
}
