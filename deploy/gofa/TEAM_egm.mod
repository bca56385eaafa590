MODULE TEAM_egm
    ! Lets TEAM guide the arm over EGM, and lets it listen to where the arm is.
    !
    ! Names that must agree with the controller's configuration (TEAM_sio.cfg, TEAM_moc.cfg,
    ! TEAM_eio.cfg): the UDP Unicast Device "TEAM", the External Motion Interface Data "TEAM", the
    ! signal EgmStop.
    !
    ! Three numbers decide how TEAM's motions come out; see the README beside this file before
    ! changing them: teamMaxSpeed, teamCondTime, teamTimeout.

    ! The tool as it is mounted. Fill in mass, centre of gravity and TCP of the real one: a wrong
    ! load makes the arm drift in lead-through and lag under EGM.
    PERS tooldata teamTool:=[TRUE,[[0,0,0],[1,0,0,0]],[0.001,[0,0,0.001],[1,0,0,0],0,0,0]];

    ! Largest joint speed that EGM may cause, deg/s. The controller's own default is 1 deg/s, with
    ! which the arm creeps. TEAM stays below its own limits; this is the controller's.
    CONST num teamMaxSpeed:=200;

    ! Where a joint counts as having arrived, deg, and for how long all of them must have before
    ! EGMRunJoint ends by itself, s. TEAM may hold the arm still for as long as it likes, so this
    ! is long, and the loop below begins anew after it.
    CONST egm_minmax teamWindow:=[-0.5,0.5];
    CONST num teamCondTime:=600;

    ! How long the controller waits for TEAM, s. TEAM answers every 4 ms.
    CONST num teamTimeout:=1;

    VAR egmident teamId;
    VAR intnum teamStopped;
    VAR bool teamEnds:=FALSE;
    VAR bool teamGuides:=FALSE;

    ! Guides the arm until EgmStop is set, the program is stopped, or an error occurs.
    ! When it ends, the arm stays where it is.
    PROC TEAM_guide()
        VAR jointtarget here;

        ! Only its rising is noticed later, so an EgmStop that is set already must keep us out.
        IF DInput(EgmStop)=1 THEN
            ErrWrite\W,"TEAM: EgmStop is set","Nothing is guided while the signal EgmStop is 1."\RL2:="Set it to 0, then start again.";
            RETURN;
        ENDIF
        teamEnds:=FALSE;
        ! After a restart the first motion has to be a Move instruction, and EGM has to begin in a
        ! fine point. This one goes nowhere.
        here:=CJointT();
        MoveAbsJ here\NoEOffs,v10,fine,teamTool\WObj:=wobj0;

        TEAM_watch;
        TEAM_open;
        EGMActJoint teamId
            \Tool:=teamTool
            \WObj:=wobj0
            \J1:=teamWindow \J2:=teamWindow \J3:=teamWindow
            \J4:=teamWindow \J5:=teamWindow \J6:=teamWindow
            \LpFilter:=20
            \SampleRate:=4
            \MaxPosDeviation:=1000
            \MaxSpeedDeviation:=teamMaxSpeed;
        teamGuides:=TRUE;
        WHILE NOT teamEnds DO
            EGMRunJoint teamId,EGM_STOP_HOLD
                \J1 \J2 \J3 \J4 \J5 \J6
                \CondTime:=teamCondTime
                \RampInTime:=0.05
                \PosCorrGain:=1;
        ENDWHILE
        TEAM_close;
    ERROR
        ! Nothing is tried again here: the arm stands, and a person decides in TEAM what comes
        ! next. TEAM sets the program pointer to main before it starts the program again.
        TEAM_close;
        IF ERRNO=ERR_UDPUC_COMM THEN
            ErrWrite "TEAM: no data","TEAM did not answer in time. The arm stands."\RL2:="Check that TEAM runs, its cable and its firewall.";
            EXIT;
        ENDIF
        RAISE;
    ENDPROC

    ! Sends where the arm is, and listens to nothing. Nothing moves. For checking the network with
    ! team doctor before the arm is guided for the first time.
    PROC TEAM_stream()
        teamEnds:=FALSE;
        TEAM_watch;
        TEAM_open;
        EGMStreamStart teamId\SampleRate:=4;
        WHILE NOT teamEnds DO
            WaitTime 0.1;
        ENDWHILE
        EGMStreamStop teamId;
        TEAM_close;
    ERROR
        TEAM_close;
        RAISE;
    ENDPROC

    ! Takes an EGM identity and connects it to TEAM. There are only four identities, and a program
    ! that was stopped in the middle keeps its own: so the old one is given back first.
    LOCAL PROC TEAM_open()
        EGMReset teamId;
        EGMGetId teamId;
        EGMSetupUC ROB_1,teamId,"TEAM","TEAM"\Joint\CommTimeout:=teamTimeout;
    ENDPROC

    LOCAL PROC TEAM_close()
        teamGuides:=FALSE;
        EGMReset teamId;
        IDelete teamStopped;
    ENDPROC

    LOCAL PROC TEAM_watch()
        IDelete teamStopped;
        CONNECT teamStopped WITH TEAM_stop;
        ISignalDI EgmStop,1,teamStopped;
    ENDPROC

    ! EgmStop was set, by TEAM or by the cell: the guided motion ends where the arm is. This is not
    ! a safety function.
    LOCAL TRAP TEAM_stop
        teamEnds:=TRUE;
        IF teamGuides THEN
            EGMStop teamId,EGM_STOP_HOLD;
        ENDIF
    ENDTRAP
ENDMODULE
