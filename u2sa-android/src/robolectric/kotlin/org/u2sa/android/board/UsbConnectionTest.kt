package org.u2sa.android.board

import android.hardware.usb.UsbManager
import ioio.lib.api.exception.ConnectionLostException
import org.assertj.core.api.Assertions.assertThat
import org.assertj.core.api.Assertions.assertThatThrownBy
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.u2sa.android.OnPhone

@RunWith(RobolectricTestRunner::class)
class UsbConnectionTest {
    private val usb = OnPhone().application.getSystemService(UsbManager::class.java)
    private val link = BoardLink("usb") { UsbConnection(usb, it) }

    @Test
    fun waitForConnect_nothingPluggedIn_saysSo() {
        assertThatThrownBy { link.newConnection().waitForConnect() }.isInstanceOf(ConnectionLostException::class.java)
        assertThat(link.trouble).isEqualTo("no IOIO at the USB port")
        assertThat(link.newConnection().canClose()).isFalse()
    }
}
