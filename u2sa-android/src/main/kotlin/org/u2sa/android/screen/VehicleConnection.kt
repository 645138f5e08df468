package org.u2sa.android.screen

import android.app.Activity
import android.content.ComponentName
import android.content.Context
import android.content.Intent
import android.content.ServiceConnection
import android.os.IBinder
import org.u2sa.android.vehicle.VehicleService

/** Binds a screen to the vehicle service while the screen is visible. */
internal class VehicleConnection(private val activity: Activity) : ServiceConnection {
    /** Null while not bound. */
    var service: VehicleService? = null
        private set

    fun open() {
        activity.bindService(Intent(activity, VehicleService::class.java), this, Context.BIND_AUTO_CREATE)
    }

    fun close() {
        activity.unbindService(this)
        service = null
    }

    /** Starts the vehicle in a service that outlives this screen. */
    fun startVehicle() {
        activity.startForegroundService(Intent(activity, VehicleService::class.java).setAction(VehicleService.START))
    }

    override fun onServiceConnected(name: ComponentName, binder: IBinder) {
        service = (binder as VehicleService.Access).service
    }

    override fun onServiceDisconnected(name: ComponentName) {
        service = null
    }
}
