package org.u2sa.android

import android.Manifest
import android.content.Intent
import android.content.res.Configuration
import android.view.View
import android.view.ViewGroup
import android.widget.Button
import android.widget.TextView
import org.assertj.core.api.Assertions.assertThat
import org.junit.After
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Robolectric
import org.robolectric.RobolectricTestRunner
import org.robolectric.RuntimeEnvironment
import org.robolectric.Shadows.shadowOf
import org.robolectric.android.controller.ActivityController
import org.robolectric.annotation.Config
import org.robolectric.shadows.ShadowAlertDialog
import org.robolectric.shadows.ShadowToast
import org.u2sa.android.vehicle.VehicleHost.Phase
import org.u2sa.android.vehicle.VehicleService

@RunWith(RobolectricTestRunner::class)
class MainActivityTest {
    private val phone = OnPhone()
    private var controller: ActivityController<MainActivity>? = null

    private val activity get() = controller!!.get()

    @After
    fun close() {
        controller?.close()
        phone.close()
    }

    private fun open() {
        phone.createService()
        controller = Robolectric.buildActivity(MainActivity::class.java).setup()
        look()
    }

    private fun look() = phone.idleFor(300)

    private fun views(): List<View> {
        fun below(view: View): List<View> =
            if (view is ViewGroup) (0 until view.childCount).flatMap { below(view.getChildAt(it)) } else listOf(view)
        return below(activity.window.decorView)
    }

    private fun shows(words: String) = views().any {
        it is TextView && it !is Button && it.visibility == View.VISIBLE && it.text.contains(words)
    }

    private fun button(label: String) = views().filterIsInstance<Button>().single { it.text.toString() == label }

    /** What Android was asked to start; Robolectric lists what was only bound as well, without an action. */
    private fun started(): List<String> =
        generateSequence { shadowOf(phone.application).nextStartedService }.mapNotNull { it.action }.toList()

    @Test
    fun open_nothingRuns_onlyStartCanBePressed() {
        open()

        assertThat(shows("Stopped")).isTrue()
        assertThat(button("Start").isEnabled).isTrue()
        listOf("Stop", "Arm", "EMERGENCY STOP").forEach { assertThat(button(it).isEnabled).describedAs(it).isFalse() }
    }

    @Test
    fun open_everyButtonAndTheTrack_canBeHeard() {
        open()
        assertThat(views().filterIsInstance<Button>()).allMatch { !it.contentDescription.isNullOrEmpty() }
        assertThat(button("EMERGENCY STOP").height).isGreaterThanOrEqualTo(96)
    }

    @Test
    fun start_allAllowed_asksAndroidForTheService() {
        phone.allowAll()
        open()
        button("Start").performClick()

        assertThat(started()).containsExactly(VehicleService.START)
    }

    @Test
    fun start_notAllowed_explainsBeforeItAsks() {
        open()
        button("Start").performClick()

        val dialog = ShadowAlertDialog.getLatestAlertDialog()
        assertThat(shadowOf(dialog).message.toString()).contains("GPS")
        assertThat(started()).isEmpty()
        dialog.getButton(android.app.AlertDialog.BUTTON_POSITIVE).performClick()
        phone.idle()
        assertThat(shadowOf(activity).lastRequestedPermission.requestedPermissions)
            .contains(Manifest.permission.ACCESS_FINE_LOCATION)
    }

    @Test
    fun permissionsDenied_saysWhatDoesNotWorkAndStartsWithTheRest() {
        open()
        activity.onRequestPermissionsResult(1, arrayOf(Manifest.permission.ACCESS_FINE_LOCATION), intArrayOf(-1))

        assertThat(shadowOf(ShadowAlertDialog.getLatestAlertDialog()).message.toString()).contains("Not allowed: location")
        assertThat(started()).containsExactly(VehicleService.START)
    }

    @Test
    @Config(sdk = [35])
    fun bluetoothDenied_boardBehindBluetooth_doesNotStart() {
        org.u2sa.android.vehicle.PhoneSettings(phone.application).board =
            org.u2sa.android.board.BoardChoice.Bluetooth("00:11:22:33:44:55")
        open()
        activity.onRequestPermissionsResult(1, arrayOf(Manifest.permission.BLUETOOTH_CONNECT), intArrayOf(-1))

        assertThat(shadowOf(ShadowAlertDialog.getLatestAlertDialog()).message.toString()).contains("Bluetooth")
        assertThat(started()).isEmpty()
    }

    @Test
    fun rotation_whileTheVehicleRuns_changesNothingForIt() {
        phone.allowAll()
        open()
        phone.startVehicle()
        phone.await("services") { phone.service.snapshot.services.isNotEmpty() }
        look()
        assertThat(shows("not armed")).isTrue()
        val before = phone.service

        RuntimeEnvironment.setQualifiers("+land")
        controller!!.configurationChange()
        look()

        assertThat(activity.resources.configuration.orientation).isEqualTo(Configuration.ORIENTATION_LANDSCAPE)
        assertThat(phone.service).isSameAs(before)
        assertThat(phone.service.state.phase).isEqualTo(Phase.RUNNING)
        assertThat(shows("not armed")).isTrue()
        assertThat(button("EMERGENCY STOP").isEnabled).isTrue()
    }

    @Test
    fun emergencyStop_pressed_isShownUntilLifted() {
        phone.allowAll()
        open()
        phone.startVehicle()
        look()
        button("EMERGENCY STOP").performClick()
        phone.await("the stop") { look().let { shows("EMERGENCY STOP by Phone") } }

        button("Clear the emergency stop").performClick()
        phone.await("its end") { look().let { shows("not armed") } }
    }

    @Test
    fun arm_pressed_asksFirst() {
        phone.allowAll()
        open()
        phone.startVehicle()
        phone.await("a position") {
            phone.isAt(-81.05, 29.19)
            look()
            button("Arm").isEnabled
        }
        button("Arm").performClick()

        assertThat(shadowOf(ShadowAlertDialog.getLatestAlertDialog()).message.toString()).contains("kill switch")
    }

    @Test
    fun open_afterTheProcessDied_saysSoAndOnlyStopCanBePressed() {
        java.io.File(phone.application.filesDir, "run-state").writeText("RUNNING")
        open()

        assertThat(shows("ended unexpectedly")).isTrue()
        assertThat(button("Start").isEnabled).isFalse()
        button("Stop").performClick()
        phone.await("stopped") { look().let { button("Start").isEnabled } }
    }

    @Test
    fun menu_whileTheVehicleRuns_changesNothingUnderIt() {
        phone.allowAll()
        open()
        phone.startVehicle()
        shadowOf(activity).clickMenuItem(0)

        assertThat(ShadowToast.getTextOfLatestToast()).isEqualTo("Stop the vehicle first")
        assertThat(shadowOf(activity).nextStartedActivity).isNull()
    }

    @Test
    fun menu_mission_opensAndroidsPicker() {
        open()
        shadowOf(activity).clickMenuItem(0)
        assertThat(shadowOf(activity).nextStartedActivity.action).isEqualTo(Intent.ACTION_OPEN_DOCUMENT)
    }

    @Test
    @Suppress("DEPRECATION") // the other way to get it is of Android 13
    fun menu_logs_areSharedWithThePermissionToReadThem() {
        open()
        shadowOf(activity).clickMenuItem(3)
        assertThat(ShadowToast.getTextOfLatestToast()).contains("no logs")

        java.io.File(phone.application.filesDir, "logs/1/a.log").apply { parentFile!!.mkdirs() }.writeText("x")
        shadowOf(activity).clickMenuItem(3)
        val chooser = shadowOf(activity).nextStartedActivity
        val send = chooser.extras!!.get(Intent.EXTRA_INTENT) as Intent
        assertThat(send.type).isEqualTo("application/zip")
        assertThat(send.flags and Intent.FLAG_GRANT_READ_URI_PERMISSION).isNotZero()
    }
}
