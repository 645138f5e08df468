package org.u2sa.android

import android.Manifest
import android.app.Application
import android.content.ComponentName
import android.content.Intent
import android.location.Location
import android.location.LocationManager
import android.os.Looper
import java.time.Duration
import org.awaitility.Awaitility.await
import org.robolectric.Robolectric
import org.robolectric.RuntimeEnvironment
import org.robolectric.Shadows.shadowOf
import org.robolectric.android.controller.ServiceController
import org.u2sa.android.vehicle.VehicleHost.Phase
import org.u2sa.android.vehicle.VehicleService

/** What the tests on Robolectric do to the phone and to the service on it. */
class OnPhone {
    val application: Application = RuntimeEnvironment.getApplication()
    private var controller: ServiceController<VehicleService>? = null

    /** The service that runs at the moment. */
    val service: VehicleService get() = controller!!.get()

    /** Gives every permission that the application asks for. */
    fun allowAll() = allow(
        Manifest.permission.ACCESS_FINE_LOCATION,
        Manifest.permission.ACCESS_COARSE_LOCATION,
        Manifest.permission.BLUETOOTH_CONNECT,
        Manifest.permission.POST_NOTIFICATIONS,
    )

    fun allow(vararg permissions: String) = shadowOf(application).grantPermissions(*permissions)

    /** Makes the service as Android does, so that screens which bind get it. */
    fun createService(): VehicleService {
        val made = Robolectric.buildService(VehicleService::class.java).create()
        controller = made
        val name = ComponentName(application, VehicleService::class.java)
        shadowOf(application).setComponentNameAndServiceForBindService(name, made.get().onBind(Intent()))
        return made.get()
    }

    /** What startForegroundService leads to. */
    fun startVehicle() {
        service.onStartCommand(Intent(VehicleService.START), 0, 1)
        awaitPhase(Phase.RUNNING)
    }

    fun awaitPhase(phase: Phase) = await(phase.name) { service.state.phase == phase }

    /** Waits, and lets the main thread do its work meanwhile. */
    fun await(what: String, atMostS: Long = 60, condition: () -> Boolean) =
        await().alias(what).pollInSameThread().pollDelay(Duration.ZERO).atMost(Duration.ofSeconds(atMostS)).until {
            idle()
            condition()
        }

    fun idle() = shadowOf(Looper.getMainLooper()).idle()

    /** Lets the main thread's delayed work come due. */
    fun idleFor(ms: Long) = shadowOf(Looper.getMainLooper()).idleFor(Duration.ofMillis(ms))

    /** The GPS has a fix. */
    fun isAt(longitude: Double, latitude: Double) {
        val location = Location(LocationManager.GPS_PROVIDER).apply {
            this.longitude = longitude
            this.latitude = latitude
            accuracy = 3.0f
            speed = 1.5f
            bearing = 45.0f
            elapsedRealtimeNanos = android.os.SystemClock.elapsedRealtimeNanos()
            time = 1_700_000_000_000
        }
        shadowOf(application.getSystemService(LocationManager::class.java)).simulateLocation(location)
        idle()
    }

    /** Ends what runs, as at the end of a test. */
    fun close() {
        controller?.let {
            it.destroy()
            check(it.get().awaitEnd(60)) { "the vehicle did not end" }
        }
        controller = null
    }
}
