package org.u2sa.android.board

import org.assertj.core.api.Assertions.assertThat
import org.assertj.core.api.Assertions.assertThatThrownBy
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import org.u2sa.interfaces.BadInputException

class BoardAddressTest {
    @ParameterizedTest
    @ValueSource(strings = ["configured", "usb", "bluetooth:00:11:22:AA:BB:CC", "tcp:192.168.0.2:4545"])
    fun parse_whatWasWritten_isTheSame(text: String) {
        assertThat(BoardChoice.parse(text).toString()).isEqualTo(text)
    }

    @ParameterizedTest
    @ValueSource(
        strings = ["", "bluetooth:", "bluetooth:00:11:22:AA:BB", "bluetooth:00:11:22:aa:bb:cc", "tcp:", "tcp:a", "tcp:a:0",
            "tcp:a:65536", "tcp:a:99999", "tcp:a b:1", "serial:/dev/ttyUSB0"],
    )
    fun parse_anythingElse_isRefusedByItsName(text: String) {
        assertThatThrownBy { BoardChoice.parse(text) }
            .isInstanceOf(BadInputException::class.java)
            .hasMessageContaining("\"$text\"")
            .hasMessageContaining("expected")
    }
}
