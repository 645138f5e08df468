package org.u2sa.core.communication.limit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.XmlConfiguration;

class OpenFilesTest {

  @Test
  void limit_asLinuxWritesIt_isTheSoftOne() {
    String line =
        "Max open files            256                  1048576              files     \n";
    assertThat(OpenFiles.limit("Limit   Soft Limit\n" + line)).hasValue(256);
  }

  @Test
  void limit_unlimitedOrNotStated_isEmpty() {
    assertThat(OpenFiles.limit("Max open files            unlimited  unlimited  files")).isEmpty();
    assertThat(OpenFiles.limit("")).isEmpty();
  }

  /** Clients, connections that have not logged in, and the process's own files fit. */
  @ParameterizedTest
  @CsvSource({"64, 16", "256, 64", "1024, 448", "1152, 512", "1048576, 512"})
  void within_openFiles_clientsLeaveRoom(int openFiles, int clients) {
    BrokerLimits limits =
        XmlConfiguration.inMemory("test", Map.of()).settings(BrokerLimits.class).get();
    assertThat(limits.within(openFiles).maxClients()).isEqualTo(clients);
    assertThat(limits.within(openFiles).clientPatience()).isEqualTo(limits.clientPatience());
  }

  /** The limit, and the files that are open before the broker starts. */
  @ParameterizedTest
  @CsvSource({"128, 20", "143, 20", "128, 101", "180, 101"})
  void requireEnough_nobodyCouldConnect_isRefused(int most, int open) {
    assertThatThrownBy(() -> OpenFiles.requireEnough(most, open))
        .isInstanceOf(BadInputException.class)
        .hasMessageStartingWith("this process may have " + most + " files open and needs ")
        .hasMessageContaining("ulimit -n");
  }

  @ParameterizedTest
  @CsvSource({"144, 20", "181, 101", "1024, 101"})
  void requireEnough_roomForClients_isAccepted(int most, int open) {
    assertThatCode(() -> OpenFiles.requireEnough(most, open)).doesNotThrowAnyException();
  }
}
