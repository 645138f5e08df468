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
 * Keeps a vehicle running whatever is on the screen (thesis 4.6): hosts the Communication Manager and the services of the chosen
 * system file, as a foreground service that holds the processor awake. Its screens bind to it and may come and go.
 *
 * When Android has to start it anew after the process died, it shows that and runs nothing.
 */
class VehicleService : Service() {
    /** What a bound screen gets. */
    inner class Access : Binder() {
        val service: VehicleService get() = this@VehicleService
    }

    private val main = Handler(Looper.getMainLooper())
    private val clock: Clock = SystemClock()
    private val warnings = Warnings()
    private lateinit var settings: AppSettings
    private lateinit var notification: VehicleNotification
    private lateinit var host: VehicleHost
    private lateinit var wakeLock: PowerManager.WakeLock
    private var announcer: Announcer? = null
    private var shown = ""
    private val look = Runnable { look() }

    /** Where the vehicle is in its life. */
    val state: VehicleHost.State get() = host.state

    /** The newest picture of the vehicle; empty while none runs. */
    val snapshot: VehicleSnapshot get() = host.cockpit?.snapshot ?: VehicleSnapshot()

    /** What went wrong with the way to the board; empty if nothing. */
    @Volatile
    var boardTrouble: () -> String = { "" }
        private set

    override fun onCreate() {
        super.onCreate()
        settings = AppSettings(this)
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
            else -> afterCrash() // Android started it anew: intent is null
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
        } catch (e: IllegalStateException) { // from Android 12 on: not from behind other applications
            refused(e)
        } catch (e: SecurityException) { // from Android 14 on: a permission is missing
            refused(e)
        }
    }

    private fun refused(e: RuntimeException): Boolean {
        host.refuse("Android does not let it run: ${e.message}")
        stopSelf()
        return false
    }

    /** GPS and camera behind a dark screen need types of their own, which need the permissions. */
    private fun foregroundTypes(): Int {
        val camera = Build.VERSION.SDK_INT >= Build.VERSION_CODES.R && isAllowed(Manifest.permission.CAMERA)
        return ServiceInfo.FOREGROUND_SERVICE_TYPE_CONNECTED_DEVICE or
            (if (isAllowed(Manifest.permission.ACCESS_FINE_LOCATION)) ServiceInfo.FOREGROUND_SERVICE_TYPE_LOCATION else 0) or
            (if (camera) ServiceInfo.FOREGROUND_SERVICE_TYPE_CAMERA else 0)
    }

    private fun isAllowed(permission: String) = checkSelfPermission(permission) == PackageManager.PERMISSION_GRANTED

    /** Ends the vehicle; also lifts the memory of a crash. */
    fun stop() = host.stop()

    /** Everything that moves goes neutral at once. On a thread of its own, so that nothing can be in its way. */
    fun emergencyStop() {
        val cockpit = host.cockpit ?: return
        thread(name = "u2sa-emergency-stop") { cockpit.emergencyStop("button on the phone") }
    }

    /** Lifts the emergency stop; the vehicle stays disarmed. */
    fun clearEmergencyStop() = order { it.clearEmergencyStop() }

    /** Asks to let the vehicle move, or no longer. */
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

    /** On the main thread, after [now] came to be; later changes come in further calls. */
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

        /** Stops everything that moves. */
        const val EMERGENCY_STOP = "org.u2sa.android.EMERGENCY_STOP"
    }
}
