package org.u2sa.android.vehicle

import android.app.NotificationManager
import android.content.Intent
import android.os.BatteryManager
import android.os.PowerManager
import java.io.File
import org.assertj.core.api.Assertions.assertThat
import org.junit.After
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.robolectric.Shadows.shadowOf
import org.robolectric.annotation.Config
import org.robolectric.shadows.ShadowPowerManager
import org.u2sa.android.OnPhone
import org.u2sa.android.vehicle.PhoneFailsafe.Hazard
import org.u2sa.android.vehicle.VehicleHost.Phase

@RunWith(RobolectricTestRunner::class)
class VehicleServiceTest {
    private val phone = OnPhone()
    private val runState = File(phone.application.filesDir, "run-state")

    @After
    fun close() = phone.close()

    private fun notification() =
        shadowOf(phone.application.getSystemService(NotificationManager::class.java)).getNotification(VehicleNotification.ID)

    private fun words() = notification().extras.getCharSequence("android.text").toString()

    @Test
    fun start_allAllowed_runsInTheForegroundAwakeAndDisarmed() {
        phone.allowAll()
        phone.createService()
        phone.startVehicle()
        phone.await("services") { phone.service.snapshot.services.any { it.name == "SafetyManager" } }

        assertThat(shadowOf(phone.service).lastForegroundNotification).isNotNull()
        assertThat(ShadowPowerManager.getLatestWakeLock().isHeld).isTrue()
        assertThat(phone.service.snapshot.armed).isFalse()
        assertThat(runState.readText()).isEqualTo("RUNNING")
        phone.idleFor(600)
        assertThat(words()).contains("not armed")
        assertThat(notification().actions.map { it.title.toString() }).containsExactly("EMERGENCY STOP")
    }

    @Test
    fun stop_whileItRuns_letsTheProcessorSleepAndLeavesTheForeground() {
        phone.allowAll()
        phone.createService()
        phone.startVehicle()
        phone.service.stop()
        phone.awaitPhase(Phase.STOPPED)
        phone.await("the end") { shadowOf(phone.service).isStoppedBySelf }

        assertThat(ShadowPowerManager.getLatestWakeLock().isHeld).isFalse()
        assertThat(shadowOf(phone.service).isForegroundStopped).isTrue()
        assertThat(runState.readText()).isEqualTo("STOPPED")
    }

    @Test
    fun startAnew_afterTheProcessDied_saysSoAndRunsNothing() {
        runState.writeText("RUNNING")
        phone.createService()
        val sticky = phone.service.onStartCommand(null, 0, 1)

        assertThat(sticky).isEqualTo(android.app.Service.START_STICKY)
        assertThat(phone.service.state.phase).isEqualTo(Phase.CRASHED)
        assertThat(words()).contains("ended unexpectedly")
        assertThat(notification().actions).isNull()
        assertThat(shadowOf(phone.service).isStoppedBySelf).isTrue()

        phone.service.stop()
        phone.awaitPhase(Phase.STOPPED)
        assertThat(runState.readText()).isEqualTo("STOPPED")
    }

    @Test
    fun emergencyStop_fromTheNotification_isShown() {
        phone.allowAll()
        phone.createService()
        phone.startVehicle()
        phone.service.onStartCommand(Intent(VehicleService.EMERGENCY_STOP), 0, 2)
        phone.await("the stop") { phone.service.snapshot.emergency != null }

        phone.idleFor(600)
        assertThat(words()).contains("EMERGENCY STOP by Phone")

        phone.service.clearEmergencyStop()
        phone.await("its end") { phone.service.snapshot.emergency == null }
    }

    @Test
    fun gps_fixes_becomeTheVehiclesTrack() {
        phone.allowAll()
        phone.createService()
        phone.startVehicle()
        phone.await("a position") {
            phone.isAt(-81.05, 29.19)
            phone.service.snapshot.motion != null
        }

        val motion = requireNotNull(phone.service.snapshot.motion)
        assertThat(motion.place.latitudeDeg()).isBetween(29.18, 29.20)
        assertThat(motion.speedMps).isBetween(1.49, 1.51)
        assertThat(motion.sigmaM).isBetween(1.98, 1.99) // 3 m hold 68 % of the errors
        assertThat(phone.service.snapshot.goals.map { it.name }).startsWith("1")
    }

    @Test
    fun locationDenied_runsButKnowsNoPlace() {
        phone.createService()
        phone.startVehicle()
        phone.await("hazard") { Hazard.POSITION_LOST in phone.service.snapshot.hazards }

        assertThat(phone.service.snapshot.motion).isNull()
        val log = phone.application.filesDir.walkTopDown().first { it.name == "PhoneSensor.log" }
        assertThat(log.readText()).contains("location permission was denied")
    }

    @Test
    fun battery_runsLow_isAHazard() {
        phone.allowAll()
        phone.createService()
        phone.startVehicle()
        val low = Intent(Intent.ACTION_BATTERY_CHANGED)
            .putExtra(BatteryManager.EXTRA_LEVEL, 7).putExtra(BatteryManager.EXTRA_SCALE, 100)
        phone.application.sendStickyBroadcastCompat(low)

        phone.await("hazard") { Hazard.BATTERY_LOW in phone.service.snapshot.hazards }
        phone.await("charge") { phone.service.snapshot.batteries["PHONE"]?.percent == 7.0 }
    }

    @Test
    @Config(sdk = [35])
    fun heat_severe_isAHazard() {
        phone.allowAll()
        phone.createService()
        phone.startVehicle()
        shadowOf(phone.application.getSystemService(PowerManager::class.java))
            .setCurrentThermalStatus(PowerManager.THERMAL_STATUS_SEVERE)

        phone.await("hazard") { Hazard.TOO_HOT in phone.service.snapshot.hazards }
    }

    @Test
    fun destroy_whileItRuns_endsTheVehicleInOrder() {
        phone.allowAll()
        phone.createService()
        phone.startVehicle()
        phone.close()

        assertThat(runState.readText()).isEqualTo("STOPPED")
        assertThat(ShadowPowerManager.getLatestWakeLock().isHeld).isFalse()
    }

    private fun android.content.Context.sendStickyBroadcastCompat(intent: Intent) {
        sendBroadcast(intent)
        phone.idle()
    }
}
