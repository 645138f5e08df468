package org.u2sa.android.board

import ioio.lib.api.exception.ConnectionLostException
import java.io.ByteArrayOutputStream
import java.io.Closeable
import java.io.IOException
import java.io.InputStream
import org.assertj.core.api.Assertions.assertThat
import org.assertj.core.api.Assertions.assertThatThrownBy
import org.junit.jupiter.api.Test

class PhoneConnectionTest {
    private var refusal: Exception? = null
    private var input: InputStream = "abc".byteInputStream()
    private val output = ByteArrayOutputStream()
    private var closed = 0
    private var aborted = 0
    private var whileConnecting = {}

    private val link = BoardLink("a board") { link ->
        object : PhoneConnection(link) {
            override fun connect(): Streams {
                whileConnecting()
                refusal?.let { throw it }
                return Streams(input, output, Closeable { closed++ })
            }

            override fun abort() {
                aborted++
            }

            override fun canClose() = true
        }
    }

    @Test
    fun waitForConnect_boardThere_carriesBytesBothWays() {
        val connection = link.newConnection()
        assertThat(link.connected()).isFalse()

        connection.waitForConnect()
        connection.outputStream.write(7)
        connection.outputStream.flush()

        assertThat(link.connected()).isTrue()
        assertThat(connection.inputStream.read()).isEqualTo('a'.code)
        assertThat(output.toByteArray()).containsExactly(7)
    }

    @Test
    fun waitForConnect_boardNotThere_saysWhy() {
        refusal = IOException("no such adapter")
        assertThatThrownBy { link.newConnection().waitForConnect() }.isInstanceOf(ConnectionLostException::class.java)

        assertThat(link.connected()).isFalse()
        assertThat(link.trouble).isEqualTo("no such adapter")
    }

    @Test
    fun waitForConnect_permissionTakenAway_isALossNotACrash() {
        refusal = SecurityException("needs BLUETOOTH_CONNECT")
        assertThatThrownBy { link.newConnection().waitForConnect() }.isInstanceOf(ConnectionLostException::class.java)
        assertThat(link.trouble).contains("BLUETOOTH_CONNECT")
    }

    @Test
    fun read_endOrFailure_isNotedAtOnce() {
        input = "".byteInputStream()
        val ending = link.newConnection().apply { waitForConnect() }
        assertThat(ending.inputStream.read(ByteArray(8), 0, 8)).isEqualTo(-1)
        assertThat(link.connected()).isFalse()
        assertThat(link.trouble).isEqualTo("the board ended the connection")

        input = object : InputStream() {
            override fun read(): Int = throw IOException("socket closed")
        }
        val breaking = link.newConnection().apply { waitForConnect() }
        assertThat(link.connected()).isTrue()
        assertThatThrownBy { breaking.inputStream.read() }.isInstanceOf(IOException::class.java)
        assertThat(link.trouble).isEqualTo("the connection broke: socket closed")
    }

    @Test
    fun disconnect_twice_closesOnce() {
        val connection = link.newConnection().apply { waitForConnect() }
        connection.disconnect()
        connection.disconnect()

        assertThat(closed).isEqualTo(1)
        assertThat(aborted).isEqualTo(1)
        assertThat(link.connected()).isFalse()
    }

    @Test
    fun disconnect_whileConnecting_leavesNothingOpen() {
        val connection = link.newConnection()
        whileConnecting = { connection.disconnect() }

        assertThatThrownBy { connection.waitForConnect() }.isInstanceOf(ConnectionLostException::class.java)
        assertThat(closed).isEqualTo(1)
        assertThat(link.connected()).isFalse()
    }

    @Test
    fun disconnect_ofAnOlderConnection_leavesTheNewOneStanding() {
        val older = link.newConnection().apply { waitForConnect() }
        val newer = link.newConnection().apply { waitForConnect() }
        older.disconnect()

        assertThat(link.connected()).isTrue()
        newer.disconnect()
        assertThat(link.connected()).isFalse()
    }

    @Test
    fun getInputStream_beforeTheConnection_isALoss() {
        assertThatThrownBy { link.newConnection().inputStream }.isInstanceOf(ConnectionLostException::class.java)
    }
}
