package org.u2sa.android.screen

import android.Manifest
import android.bluetooth.BluetoothAdapter
import android.bluetooth.BluetoothManager
import android.view.View
import android.view.ViewGroup
import android.widget.Button
import android.widget.EditText
import android.widget.RadioButton
import org.assertj.core.api.Assertions.assertThat
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Robolectric
import org.robolectric.RobolectricTestRunner
import org.robolectric.Shadows.shadowOf
import org.robolectric.annotation.Config
import org.robolectric.shadows.ShadowToast
import org.u2sa.android.OnPhone
import org.u2sa.android.board.BoardChoice
import org.u2sa.android.vehicle.AppSettings

private const val DEVICE = "00:11:22:33:44:55"

@RunWith(RobolectricTestRunner::class)
class SettingsActivityTest {
    private val phone = OnPhone()
    private val settings = AppSettings(phone.application)

    private fun views(view: View): List<View> =
        if (view is ViewGroup) (0 until view.childCount).flatMap { views(view.getChildAt(it)) } + view else listOf(view)

    private fun pair() {
        phone.allow(Manifest.permission.BLUETOOTH_CONNECT)
        val adapter: BluetoothAdapter = phone.application.getSystemService(BluetoothManager::class.java).adapter
        shadowOf(adapter).setBondedDevices(setOf(adapter.getRemoteDevice(DEVICE)))
    }

    private fun change(edit: (List<View>) -> Unit) =
        Robolectric.buildActivity(SettingsActivity::class.java).setup().use { controller ->
            edit(views(controller.get().window.decorView))
            controller.pause()
        }

    private fun List<View>.choose(tag: String) = filterIsInstance<RadioButton>().single { it.tag == tag }.performClick()

    @Test
    fun board_pairedAdapterChosen_isKept() {
        pair()
        change { it.choose("bluetooth:$DEVICE") }
        assertThat(settings.board).isEqualTo(BoardChoice.Bluetooth(DEVICE))
    }

    @Test
    fun board_tcpAddressTyped_isKept() {
        change {
            it.choose("tcp:")
            it.filterIsInstance<EditText>().first().setText("10.0.0.1:4545")
        }
        assertThat(settings.board).isEqualTo(BoardChoice.Tcp("10.0.0.1", 4545))
    }

    @Test
    fun board_nonsenseTyped_isSaidAndNotKept() {
        change {
            it.choose("tcp:")
            it.filterIsInstance<EditText>().first().setText("nowhere")
        }
        assertThat(ShadowToast.getTextOfLatestToast()).contains("tcp:nowhere").contains("expected")
        assertThat(settings.board).isEqualTo(BoardChoice.Usb)
    }

    @Test
    @Config(sdk = [35])
    fun bluetoothDenied_noAdaptersAreListedButTheButtonAsks() {
        change { all ->
            assertThat(all.filterIsInstance<RadioButton>().map { it.tag }).containsExactly("configured", "usb", "tcp:")
            assertThat(all.filterIsInstance<Button>().map { it.text.toString() }).anyMatch { it.startsWith("Allow Bluetooth") }
        }
    }

    @Test
    fun battery_numberTyped_isKeptWithinAHundred() {
        change { it.filterIsInstance<EditText>().last().setText("900") }
        assertThat(settings.lowBatteryPercent).isEqualTo(100)
    }
}
