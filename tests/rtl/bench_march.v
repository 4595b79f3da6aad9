// The worked examples S18 to S24 of SPEC.md: corners to weighted samples, and three samples under
// and over one another, in 8 and 16 bits.
`default_nettype none

// Three samples of one ray through opacity and march, one every RAYS clocks. The other rays, which
// share the unit, stay empty.
module three_samples #(
    parameter BITS = 8,
    parameter BACK_TO_FRONT = 0,
    parameter RAYS = BACK_TO_FRONT ? 3 : 2
) (
    input  wire                   clock,
    input  wire [7:0]             edges,
    input  wire [3*(BITS+16)-1:0] opacities, // O of the samples, the first one lowest
    input  wire [3*96-1:0]        lights,
    output wire [127:0]           ray        // E[2], E[1], E[0], T
);
    wire [1:0]       sample = edges / RAYS;
    wire             taken = edges % RAYS == 0 && edges < 3 * RAYS;
    wire             first, first2, ended;
    wire [BITS+15:0] opacity_now;
    wire [95:0]      lights_now, lights2;
    wire [31:0]      a32;

    assign first = edges < RAYS;
    assign opacity_now = taken ? opacities[(BITS+16)*sample +: BITS+16] : 0;
    assign lights_now = taken ? lights[96*sample +: 96] : 0;
    opacity #(.BITS(BITS)) widen (clock, opacity_now, a32);
    delay #(.WIDTH(97), .CLOCKS(2)) delay_lights (clock, {first, lights_now}, {first2, lights2});
    march #(.BACK_TO_FRONT(BACK_TO_FRONT)) march (clock, first2, lights2, a32, 16'd0,
        ray[127:32], ray[31:0], ended);
endmodule

module bench_march (
    output reg done
);
    localparam WIDEN = 2; // clocks of opacity

    reg         clock;
    reg [7:0]   edges;
    integer     wrong, checks, q;
    reg [63:0]  opacities8;
    reg [127:0] opacities16;
    reg [191:0] colours8;
    reg [383:0] colours16;
    reg [7:0]   entry [0:3];

    initial begin
        clock = 0;
        edges = 0;
        wrong = 0;
        checks = 0;
        done = 0;
        for (q = 0; q < 8; q = q + 1) begin // the corners of S18 and S19
            entry[0] = 10 * q + 1;
            entry[1] = 255 - 30 * q;
            entry[2] = 7 * q * q;
            entry[3] = 37 * q + 5;
            colours8[8*q +: 8] = entry[0];
            colours8[8*(8+q) +: 8] = entry[1];
            colours8[8*(16+q) +: 8] = entry[2];
            opacities8[8*q +: 8] = entry[3];
            colours16[16*q +: 16] = 257 * entry[0] + q;
            colours16[16*(8+q) +: 16] = 257 * entry[1] + q;
            colours16[16*(16+q) +: 16] = 257 * entry[2] + q;
            opacities16[16*q +: 16] = 257 * entry[3] + q;
        end
    end
    always #1 clock = !clock;

    wire [23:0] opacity8;
    wire [31:0] opacity16;
    wire [95:0] lights8, lights16;
    wire        skipped8, skipped16;

    interpolate #(.BITS(8)) from8 (clock, 8'd85, 8'd170, 8'd3, opacities8, colours8, opacity8,
        lights8, skipped8);
    interpolate #(.BITS(16)) from16 (clock, 8'd85, 8'd170, 8'd3, opacities16, colours16, opacity16,
        lights16, skipped16);

    // S18 or S19, S20, S21: the last one highest.
    localparam [71:0] O8 = {24'd5177344, 24'd4423680, 24'd4423680};
    localparam [287:0] L8 = {32'd144965632, 32'd1009582080, 32'd108724224,
        32'd127550160, 32'd901497600, 32'd79937280,
        32'd195469032, 32'd813840960, 32'd109156160};
    localparam [95:0] O16 = {32'd1330708480, 32'd1136997632, 32'd1136997632};
    localparam [287:0] L16 = {32'd146155390, 32'd1017625685, 32'd109626695,
        32'd128590857, 32'd908673325, 32'd80600553,
        32'd197060302, 32'd820331968, 32'd110062946};
    wire [127:0] under8, under16, over8, over16;

    three_samples #(.BITS(8)) march_under8 (clock, edges, O8, L8, under8);
    three_samples #(.BITS(16)) march_under16 (clock, edges, O16, L16, under16);
    three_samples #(.BITS(8), .BACK_TO_FRONT(1)) march_over8 (clock, edges, O8, L8, over8);
    three_samples #(.BITS(16), .BACK_TO_FRONT(1)) march_over16 (clock, edges, O16, L16, over16);

    task expect_equal(input [3*8-1:0] id, input [127:0] found, input [127:0] expected);
        begin
            checks = checks + 1;
            if (found !== expected) begin
                wrong = wrong + 1;
                $display("# %0s: expected %h, found %h", id, expected, found);
            end
        end
    endtask

    always @(negedge clock) if (!done) begin
        edges = edges + 1;
        case (edges)
            WIDEN + 2: expect_equal("S23", under8, {32'd97734516, 32'd406920480, 32'd54578080,
                32'd1579032094});
            WIDEN + 3: expect_equal("S24", over8, {32'd97734516, 32'd406920480, 32'd54578080,
                32'd1579032094});
            WIDEN + 3 * 2: begin
                expect_equal("S23", under8, {32'd183816331, 32'd1011272452, 32'd113358066,
                    32'd801354235});
                expect_equal("S23", under16, {32'd185311727, 32'd1019299184, 32'd114296125,
                    32'd801262030});
            end
            9: begin
                expect_equal("S18", {8'd0, opacity8, lights8}, {O8[23:0], L8[95:0]});
                expect_equal("S19", {opacity16, lights16}, {O16[31:0], L16[95:0]});
            end
            WIDEN + 3 * 3: begin
                expect_equal("S24", over8, {32'd166100111, 32'd1022407064, 32'd109646529,
                    32'd801354235});
                expect_equal("S24", over16, {32'd167451971, 32'd1030521837, 32'd110553301,
                    32'd801262030});
                $display("%0s march %0d", wrong == 0 ? "PASS" : "FAIL",
                    wrong == 0 ? checks : wrong);
                done = 1;
            end
            default: ;
        endcase
    end
endmodule
