package org.u2sa.android.board

import android.Manifest
import android.bluetooth.BluetoothAdapter
import android.bluetooth.BluetoothManager
import ioio.lib.api.exception.ConnectionLostException
import org.assertj.core.api.Assertions.assertThat
import org.assertj.core.api.Assertions.assertThatThrownBy
import org.junit.Before
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.robolectric.Shadows.shadowOf
import org.u2sa.android.OnPhone

private const val DEVICE = "00:11:22:33:44:55"

@RunWith(RobolectricTestRunner::class)
class BluetoothConnectionTest {
    private val phone = OnPhone()
    private val adapter: BluetoothAdapter = phone.application.getSystemService(BluetoothManager::class.java).adapter
    private val link = BoardLink("bluetooth:$DEVICE") { BluetoothConnection(adapter, DEVICE, it) }

    @Before
    fun allow() {
        phone.allow(Manifest.permission.BLUETOOTH_CONNECT)
        shadowOf(adapter).setState(BluetoothAdapter.STATE_ON)
    }

    @Test
    fun waitForConnect_adapterThere_isConnected() {
        val connection = link.newConnection()
        connection.waitForConnect()
        connection.outputStream.write(byteArrayOf(1, 2, 3))

        assertThat(link.connected()).isTrue()
        assertThat(connection.canClose()).isTrue()
        connection.disconnect()
        assertThat(link.connected()).isFalse()
    }

    @Test
    fun waitForConnect_bluetoothSwitchedOff_saysSo() {
        shadowOf(adapter).setState(BluetoothAdapter.STATE_OFF)
        assertThatThrownBy { link.newConnection().waitForConnect() }.isInstanceOf(ConnectionLostException::class.java)
        assertThat(link.trouble).isEqualTo("Bluetooth is switched off")
    }

    @Test
    fun waitForConnect_phoneWithoutBluetooth_saysSo() {
        val none = BoardLink("bluetooth:$DEVICE") { BluetoothConnection(null, DEVICE, it) }
        assertThatThrownBy { none.newConnection().waitForConnect() }.isInstanceOf(ConnectionLostException::class.java)
        assertThat(none.trouble).isEqualTo("the phone has no Bluetooth")
    }

    @Test
    fun read_afterTheLinkBroke_isALossAtOnce() {
        val connection = link.newConnection()
        connection.waitForConnect()
        connection.disconnect()

        assertThat(link.connected()).isFalse()
        assertThatThrownBy { link.newConnection().inputStream }.isInstanceOf(ConnectionLostException::class.java)
    }
}
