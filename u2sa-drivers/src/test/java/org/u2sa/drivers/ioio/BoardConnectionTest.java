package org.u2sa.drivers.ioio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import ioio.lib.api.exception.ConnectionLostException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;

class BoardConnectionTest {
  @ParameterizedTest
  @ValueSource(strings = {"serial:/dev/ttyACM0", "tcp:127.0.0.1:4545", "tcp:[::1]:4545"})
  void of_address_isThatConnection(String address) {
    BoardConnection connection = BoardConnection.of(address);
    assertThat(connection.address()).isEqualTo(address);
    assertThat(connection.isLockstep()).isFalse();
    assertThat(connection.newConnection()).isNotSameAs(connection.newConnection());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "serial:",
        "tcp:",
        "tcp:host",
        "tcp:host:",
        "tcp::1",
        "tcp:h:0",
        "tcp:h:70000"
      })
  void of_noAddress_saysWhatIsExpected(String address) {
    assertThatThrownBy(() -> BoardConnection.of(address))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("IOIO: \"" + address + "\"");
  }

  @Test
  void waitForConnect_serialPortThatIsAbsent_saysSo() {
    assertThatThrownBy(
            () -> BoardConnection.of("serial:/dev/no-such-port").newConnection().waitForConnect())
        .isInstanceOf(ConnectionLostException.class)
        .cause()
        .hasMessageContaining("port");
  }
}
