package org.u2sa.android.vehicle

import android.Manifest
import android.app.Service
import android.content.Context
import android.content.Intent
import android.content.pm.PackageManager
import android.content.pm.ServiceInfo
import android.os.Binder
import android.os.Build
import android.os.Handler
import android.os.IBinder
import android.os.Looper
import android.os.PowerManager
import android.util.Log
import kotlin.concurrent.thread
import org.u2sa.android.file.shippedFiles
import org.u2sa.android.file.vehicleFiles
import org.u2sa.interfaces.BadInputException
import org.u2sa.interfaces.time.Clock
import org.u2sa.interfaces.time.SystemClock

private const val LOOK_EVERY_MS = 500L
private const val TAG = "u2sa"

/**
 * Foreground service that keeps a vehicle running regardless of the screen (thesis 4.6): hosts the Communication Manager and
 * the services of the chosen system file, and holds a wake lock. Activities bind to it.
 *
 * When Android restarts it after the process died, it reports the crash and starts no vehicle.
 */
class VehicleService : Service() {
    /** Binder for the activities. */
    inner class Access : Binder() {
        val service: VehicleService get() = this@VehicleService
    }

    private val main = Handler(Looper.getMainLooper())
    private val clock: Clock = SystemClock()
    private val warnings = Warnings()
    private lateinit var settings: PhoneSettings
    private lateinit var notification: VehicleNotification
    private lateinit var host: VehicleHost
    private lateinit var wakeLock: PowerManager.WakeLock
    private var announcer: Announcer? = null
    private var shown = ""
    private val look = Runnable { look() }

    /** Life-cycle phase of the vehicle. */
    val state: VehicleHost.State get() = host.state

    /** Latest snapshot of the vehicle; empty while none runs. */
    val snapshot: VehicleSnapshot get() = host.cockpit?.snapshot ?: VehicleSnapshot()

    /** Fault of the board connection; empty if none. */
    @Volatile
    var boardTrouble: () -> String = { "" }
        private set

    override fun onCreate() {
        super.onCreate()
        settings = PhoneSettings(this)
        notification = VehicleNotification(this)
        val power = getSystemService(Context.POWER_SERVICE) as PowerManager
        wakeLock = power.newWakeLock(PowerManager.PARTIAL_WAKE_LOCK, "u2sa:vehicle").apply { setReferenceCounted(false) }
        val files = vehicleFiles(this)
        try {
            files.install(shippedFiles(this), version())
        } catch (e: BadInputException) {
            Log.e(TAG, "installing the configurations: ${e.message}")
        }
        host = VehicleHost(RunStateFile(files.runState), clock) { main.post { changed(it) } }
    }

    private fun version(): String = packageManager.getPackageInfo(packageName, 0).lastUpdateTime.toString()

    override fun onBind(intent: Intent): IBinder = Access()

    override fun onStartCommand(intent: Intent?, flags: Int, startId: Int): Int {
        when (intent?.action) {
            START -> start()
            EMERGENCY_STOP -> emergencyStop()
            else -> afterCrash() // restarted by Android: intent is null
        }
        return START_STICKY
    }

    private fun afterCrash() {
        if (!host.state.isActive) {
            notification.show(StatusLine.of(this, host.state, snapshot).words, running = false)
            stopSelf()
        }
    }

    private fun start() {
        if (!goToForeground()) {
            return
        }
        wakeLock.acquire()
        announcer = announcer ?: if (settings.speak) Announcer(this) else null
        val plan = VehiclePlan(this, settings, clock)
        boardTrouble = plan::boardTrouble
        val order = try {
            plan.order()
        } catch (e: BadInputException) {
            host.refuse(e.message.orEmpty())
            return
        }
        host.start(order)
    }

    private fun goToForeground(): Boolean {
        val words = StatusLine.of(this, host.state, snapshot).words
        return try {
            if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.Q) {
                startForeground(VehicleNotification.ID, notification.of(words, running = true), foregroundTypes())
            } else {
                startForeground(VehicleNotification.ID, notification.of(words, running = true))
            }
            true
        } catch (e: IllegalStateException) { // since Android 12: not allowed from the background
            refused(e)
        } catch (e: SecurityException) { // since Android 14: missing permission
            refused(e)
        }
    }

    private fun refused(e: RuntimeException): Boolean {
        host.refuse("Android does not let it run: ${e.message}")
        stopSelf()
        return false
    }

    /** GPS and camera in the background require their own service types and permissions. */
    private fun foregroundTypes(): Int {
        val camera = Build.VERSION.SDK_INT >= Build.VERSION_CODES.R && isAllowed(Manifest.permission.CAMERA)
        return ServiceInfo.FOREGROUND_SERVICE_TYPE_CONNECTED_DEVICE or
            (if (isAllowed(Manifest.permission.ACCESS_FINE_LOCATION)) ServiceInfo.FOREGROUND_SERVICE_TYPE_LOCATION else 0) or
            (if (camera) ServiceInfo.FOREGROUND_SERVICE_TYPE_CAMERA else 0)
    }

    private fun isAllowed(permission: String) = checkSelfPermission(permission) == PackageManager.PERMISSION_GRANTED

    /** Stops the vehicle; also acknowledges a crash. */
    fun stop() = host.stop()

    /** Sets all actuators neutral immediately. Runs on its own thread so that nothing can block it. */
    fun emergencyStop() {
        val cockpit = host.cockpit ?: return
        thread(name = "u2sa-emergency-stop") { cockpit.emergencyStop("button on the phone") }
    }

    /** Clears the emergency stop; the vehicle stays disarmed. */
    fun clearEmergencyStop() = order { it.clearEmergencyStop() }

    /** Requests arming or disarming. */
    fun arm(wanted: Boolean) = order { it.arm(wanted) }

    private fun order(order: (Cockpit) -> Unit) {
        val cockpit = host.cockpit ?: return
        thread(name = "u2sa-phone-order") { order(cockpit) }
    }

    private fun look() {
        val news = warnings.news(snapshot)
        announcer?.say(news)
        val words = StatusLine.of(this, host.state, snapshot).words
        if (words != shown) {
            shown = words
            notification.show(words, running = true)
        }
        main.postDelayed(look, LOOK_EVERY_MS)
    }

    /** Called on the main thread on every state change. */
    private fun changed(now: VehicleHost.State) {
        main.removeCallbacks(look)
        if (now.isActive || host.state.isActive) {
            look()
        } else {
            wakeLock.release()
            announcer?.close()
            announcer = null
            stopForeground(STOP_FOREGROUND_REMOVE)
            stopSelf()
        }
    }

    override fun onDestroy() {
        main.removeCallbacksAndMessages(null)
        host.close()
        announcer?.close()
        wakeLock.release()
        super.onDestroy()
    }

    /** Waits until the vehicle has ended after [onDestroy]. */
    internal fun awaitEnd(seconds: Long): Boolean = host.awaitEnd(seconds)

    companion object {
        /** Starts the chosen vehicle, disarmed. */
        const val START = "org.u2sa.android.START"

        /** Emergency stop. */
        const val EMERGENCY_STOP = "org.u2sa.android.EMERGENCY_STOP"
    }
}
