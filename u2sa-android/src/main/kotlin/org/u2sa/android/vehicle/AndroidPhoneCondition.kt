package org.u2sa.android.vehicle

import android.content.BroadcastReceiver
import android.content.Context
import android.content.Intent
import android.content.IntentFilter
import android.os.BatteryManager
import android.os.Build
import android.os.PowerManager

private const val PERCENT = 100.0

/** The condition of the phone that this runs on, as Android tells of each change until [close]. */
class AndroidPhoneCondition(private val context: Context) : PhoneCondition, AutoCloseable {
    @Volatile private var batteryPercent: Double? = null
    @Volatile private var charging = false
    @Volatile private var heat: PhoneCondition.Heat? = null

    private val power = context.getSystemService(Context.POWER_SERVICE) as PowerManager
    private val battery = object : BroadcastReceiver() {
        override fun onReceive(context: Context, intent: Intent) = take(intent)
    }

    /** Of Android 10 and newer only: kept without its type, which older phones do not know. */
    private val thermometer: Any?

    init {
        context.registerReceiver(battery, IntentFilter(Intent.ACTION_BATTERY_CHANGED))?.let(::take) // says at once how it is
        thermometer = if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.Q) listenToHeat() else null
    }

    private fun listenToHeat(): Any {
        val listener = PowerManager.OnThermalStatusChangedListener { status -> heat = heatOf(status) }
        heat = heatOf(power.currentThermalStatus)
        power.addThermalStatusListener(context.mainExecutor, listener)
        return listener
    }

    private fun heatOf(status: Int) = PhoneCondition.Heat.entries.getOrNull(status)

    private fun take(intent: Intent) {
        val level = intent.getIntExtra(BatteryManager.EXTRA_LEVEL, -1)
        val scale = intent.getIntExtra(BatteryManager.EXTRA_SCALE, -1)
        batteryPercent = if (level >= 0 && scale > 0) PERCENT * level / scale else null
        charging = intent.getIntExtra(BatteryManager.EXTRA_PLUGGED, 0) != 0
    }

    override fun read() = PhoneCondition.Reading(batteryPercent, charging, heat)

    override fun close() {
        context.unregisterReceiver(battery)
        if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.Q && thermometer != null) {
            power.removeThermalStatusListener(thermometer as PowerManager.OnThermalStatusChangedListener)
        }
    }
}
